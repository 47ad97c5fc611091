// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// Pictures of a study: strips of the worst places over the bias, and a sheet of them all.
#ifndef penumbra_tool_BiasSheet_h
#define penumbra_tool_BiasSheet_h

#include "lab/BiasStudy.h"

namespace penumbra::tool
{
/// Two rows, where acne and where gaps are worst, over the bias, with what rays show at the right; a
/// frame's colour tells what is wrong: red acne, blue a gap, green neither.
Picture DrawStrip(const BiasStudy& study, std::size_t sweep);

/// The whole view with both places marked, all strips, and the plot.
Picture DrawSheet(const BiasStudy& study, const Picture& plot);
}

#endif
