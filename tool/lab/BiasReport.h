// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/// What a study of the bias found, for machines and for people.
#ifndef penumbra_tool_BiasReport_h
#define penumbra_tool_BiasReport_h

#include "lab/BiasStudy.h"

#include <nlohmann/json.hpp>

namespace penumbra::tool
{
/// All numbers of the study.
nlohmann::ordered_json DescribeStudy(const BiasStudy& study);

/// "constant bias: safe from 1 to 2.5 texels; take 1.5, ..." for each kind, then the defaults; a line
/// each.
std::string SummarizeStudy(const BiasStudy& study);

/// "as set (constant 0.25, slope 0.4): safe": the biases that the map had before the sweep.
std::string SummarizeDefaults(const BiasStudy& study);

/// "0.12 %" of a share; what is too little to matter as "under 0.001 %".
std::string FormatPercent(double share);

/// "safe from 1 to 2.5 texels; take 1.5": of one kind.
std::string SummarizeWindow(const BiasSweep& sweep, const BiasLimits& limits);
}

#endif
