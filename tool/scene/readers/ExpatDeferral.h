// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Makes VTK's XML files readable with today's expat.
#pragma once

namespace penumbra::tool
{
/// Keeps this file's replacement of XML_ParserCreate() in the program; does nothing else.
void KeepXmlReadable();
}
