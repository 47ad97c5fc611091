// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The sun's place in the sky at a place and time.
 */
#pragma once

namespace penumbra
{
struct SunPosition
{
  double Elevation = 0.0; ///< degrees above the horizon, without refraction
  double Azimuth = 0.0;   ///< degrees clockwise from north
};

/// Position for 1950 to 2050, within 0.01 degrees. latitude, longitude: degrees north and east. days: days since noon
/// (UTC) of 1 January 2000. Michalsky 1988, The Astronomical Almanac's Algorithm for Approximate Solar Position. The
/// azimuth comes from an arc tangent, which is right in the southern hemisphere too.
SunPosition FindSun(double latitude, double longitude, double days);

/// Refraction in degrees by air of 1010 hPa and 10 degrees Celsius, to be added to the elevation; below -1 degree, that of
/// -1 degree. Reda and Andreas 2004, Solar Position Algorithm for Solar Radiation Applications, equation 42.
double Refraction(double elevation);

/// Days since noon (UTC) of 1 January 2000 of a time in the form 2003-10-17T19:30:30Z. Seconds may be left out;
/// an offset such as +02:00 may stand for Z, and nothing means UTC. Returns false for other text and impossible times.
bool ParseTime(const char* text, double& days);
}
