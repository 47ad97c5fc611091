// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sky/SunPosition.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace penumbra
{
namespace
{
constexpr double HalfTurn = 180.0;

double Wrapped(double degrees)
{
  return degrees - 2.0 * HalfTurn * std::floor(degrees / (2.0 * HalfTurn));
}

// Days since 1 January 2000 in the Gregorian calendar. Fliegel and Van Flandern 1968, A Machine Algorithm for
// Processing Calendar Dates.
long DaysFromDate(int year, int month, int day)
{
  const int shift = (month - 14) / 12;
  return day - 32075L + 1461L * (year + 4800 + shift) / 4 + 367L * (month - 2 - shift * 12) / 12 -
    3L * ((year + 4900 + shift) / 100) / 4 - 2451545L;
}

int DaysInMonth(int year, int month)
{
  return static_cast<int>(
    DaysFromDate(month == 12 ? year + 1 : year, month % 12 + 1, 1) - DaysFromDate(year, month, 1));
}
}

SunPosition FindSun(double latitude, double longitude, double days)
{
  const double anomaly = glm::radians(357.528 + 0.9856003 * days);
  const double ecliptic = glm::radians(Wrapped(280.460 + 0.9856474 * days) +
    1.915 * std::sin(anomaly) + 0.020 * std::sin(2.0 * anomaly));
  const double obliquity = glm::radians(23.439 - 0.0000004 * days);
  const double ascension = std::atan2(std::cos(obliquity) * std::sin(ecliptic), std::cos(ecliptic));
  const double declination = std::asin(std::sin(obliquity) * std::sin(ecliptic));
  const double hour = 24.0 * (days + 0.5 - std::floor(days + 0.5)); // of the day, UTC
  const double siderealHour = 6.697375 + 0.0657098242 * days + hour;
  const double hourAngle = glm::radians(Wrapped(15.0 * siderealHour + longitude)) - ascension;
  const double lat = glm::radians(latitude);
  SunPosition sun;
  sun.Elevation = glm::degrees(std::asin(std::clamp(std::sin(declination) * std::sin(lat) +
      std::cos(declination) * std::cos(lat) * std::cos(hourAngle),
    -1.0, 1.0)));
  sun.Azimuth = Wrapped(glm::degrees(std::atan2(-std::cos(declination) * std::sin(hourAngle),
    std::sin(declination) * std::cos(lat) -
      std::cos(declination) * std::sin(lat) * std::cos(hourAngle))));
  return sun;
}

double Refraction(double elevation)
{
  const double e = std::max(elevation, -1.0);
  return 1.02 / (60.0 * std::tan(glm::radians(e + 10.3 / (e + 5.11))));
}

bool ParseTime(const char* text, double& days)
{
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, length = 0;
  double second = 0.0;
  if (!text ||
    std::sscanf(text, "%4d-%2d-%2dT%2d:%2d%n", &year, &month, &day, &hour, &minute, &length) != 5)
  {
    return false;
  }
  const char* rest = text + length;
  if (*rest == ':')
  {
    if (std::sscanf(rest, ":%6lf%n", &second, &length) != 1)
    {
      return false;
    }
    rest += length;
  }
  int offset = 0; // minutes east of Greenwich
  if (*rest == '+' || *rest == '-')
  {
    int hours = 0, minutes = 0;
    if (std::sscanf(rest + 1, "%2d:%2d%n", &hours, &minutes, &length) != 2 || hours < 0 ||
      hours > 14 || minutes < 0 || minutes > 59)
    {
      return false;
    }
    offset = (*rest == '-' ? -1 : 1) * (60 * hours + minutes);
    rest += 1 + length;
  }
  else if (*rest == 'Z')
  {
    ++rest;
  }
  const bool possible = *rest == '\0' && year >= 1950 && year <= 2050 && month >= 1 &&
    month <= 12 && day >= 1 && day <= DaysInMonth(year, month) && hour >= 0 && hour < 24 &&
    minute >= 0 && minute < 60 && second >= 0.0 && second < 61.0;
  if (possible)
  {
    days = static_cast<double>(DaysFromDate(year, month, day)) - 0.5 +
      (hour + (minute - offset + second / 60.0) / 60.0) / 24.0;
  }
  return possible;
}
}
