// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Since expat 2.6.0, and in Debian 12's 2.5.0-1+deb12u1 and later, the parser puts off handling a tag
// that arrives in pieces. VTK before 9.3.1 hands it <AppendedData> in pieces and needs to be told at
// once, so that it fails on every XML file with appended data, the writers' default
// (https://gitlab.kitware.com/vtk/vtk/-/issues/19258). This program's XML_ParserCreate() comes before
// the library's and switches the delay off.
#include "scene/readers/ExpatDeferral.h"

#include <expat.h>

// Older libraries lack it, and the delay.
extern "C" XML_Bool XMLCALL XML_SetReparseDeferralEnabled(XML_Parser, XML_Bool)
  __attribute__((weak));

extern "C" __attribute__((visibility("default"))) XML_Parser XMLCALL XML_ParserCreate(
  const XML_Char* encoding)
{
  // What the library's own XML_ParserCreate() does.
  XML_Parser parser = XML_ParserCreate_MM(encoding, nullptr, nullptr);
  if (parser && XML_SetReparseDeferralEnabled)
  {
    XML_SetReparseDeferralEnabled(parser, XML_FALSE);
  }
  return parser;
}

namespace penumbra::tool
{
void KeepXmlReadable() {}
}
