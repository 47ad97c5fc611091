// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"
#include "Skips.h"

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <string>

namespace
{
bool HasOSMesa()
{
  return dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL) ||
    dlopen("libOSMesa.so.6", RTLD_LAZY | RTLD_LOCAL) ||
    dlopen("libOSMesa.so", RTLD_LAZY | RTLD_LOCAL);
}
}

int main(int argc, char** argv)
{
  const char* backend = std::getenv("PENUMBRA_BACKEND");
  if (backend && std::string(backend) == "osmesa" && !HasOSMesa())
  {
    std::puts("Skipped: every case: libOSMesa is not installed; Mesa after 25.0 has none.");
    return penumbra_test::AllSkipped;
  }
  testing::InitGoogleTest(&argc, argv);
  penumbra_test::WatchMessages();
  return penumbra_test::RunTests();
}
