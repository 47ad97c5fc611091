// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Since expat 2.6.0, and in Debian 12 since 2.5.0-1+deb12u1, the parser defers a tag that arrives in pieces. VTK before
// 9.3.1 passes <AppendedData> in pieces and relies on an immediate callback, so it fails to read any XML file with appended
// data, which its writers produce by default (https://gitlab.kitware.com/vtk/vtk/-/issues/19258). This program's
// XML_ParserCreate() replaces the library's and switches the deferral off.
#include "scene/readers/FormatReaders.h"

#include <expat.h>

// Older libraries have neither this function nor the deferral.
extern "C" XML_Bool XMLCALL XML_SetReparseDeferralEnabled(XML_Parser, XML_Bool)
  __attribute__((weak));

extern "C" __attribute__((visibility("default"))) XML_Parser XMLCALL XML_ParserCreate(
  const XML_Char* encoding)
{
  // As in the library's XML_ParserCreate().
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
