// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGISkySource
 * @brief   makes a sky and installs it as a renderer's environment
 *
 * The sky is an equirectangular image of linear radiance: a uniform colour, a gradient, or clear daylight with its sun,
 * and soft boxes in it. ApplyTo() makes it the renderer's environment texture. VTK's physically based materials and all
 * of Penumbra's techniques that use the environment then see it.
 *
 * Scale: a uniform sky of radiance 1 gives a white diffuse surface the radiance 1. In daylight, the sun above the
 * atmosphere gives a white surface that faces it the radiance 1; on the ground, sun and sky follow from that.
 *
 * Directions: the elevation is in degrees above the horizon. The azimuth of a sky that stands in the world is a compass
 * bearing in degrees, clockwise from GetNorth(). In a sky that follows the camera, azimuth 0 is toward the camera, and
 * positive ones are to its right, as with a key light.
 *
 * Numbers out of range are limited; those that are not finite are refused.
 *
 * @code
 * vtkNew<vtkGISkySource> sky;
 * sky->SetKindToDaylight();
 * sky->SetSunByTime(48.86, 2.35, "2026-06-21T16:00Z");
 * sky->ApplyTo(renderer);
 * @endcode
 *
 * @sa vtkGISoftBox
 */
#ifndef vtkGISkySource_h
#define vtkGISkySource_h

#include "vtkNew.h" // for the sun
#include "vtkObject.h"
#include "vtkRenderingGIModule.h"
#include "vtkSmartPointer.h" // for boxes

#include <vector> // for boxes

class vtkGISoftBox;
class vtkImageData;
class vtkLight;
class vtkRenderer;

namespace penumbra
{
class SkyInstallation;
}

class VTKRENDERINGGI_EXPORT vtkGISkySource : public vtkObject
{
public:
  static vtkGISkySource* New();
  vtkTypeMacro(vtkGISkySource, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override;

  enum Kinds
  {
    UNIFORM = 0,
    GRADIENT,
    DAYLIGHT
  };

  ///@{
  /**
   * Kind of the sky, apart from its soft boxes. Default: UNIFORM.
   */
  vtkSetClampMacro(Kind, int, UNIFORM, DAYLIGHT);
  vtkGetMacro(Kind, int);
  void SetKindToUniform() { this->SetKind(UNIFORM); }
  void SetKindToGradient() { this->SetKind(GRADIENT); }
  void SetKindToDaylight() { this->SetKind(DAYLIGHT); }
  ///@}

  ///@{
  /**
   * Factor of the radiance of sky and sun; soft boxes have their own. 0 to 1e6. Default: 1.
   */
  void SetStrength(double strength);
  vtkGetMacro(Strength, double);
  ///@}

  ///@{
  /**
   * Radiance of a uniform sky. Default: white.
   */
  void SetColor(double r, double g, double b);
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /**
   * Radiances of a gradient straight up, at the horizon, and straight down. Between them the colours blend by a smooth
   * step of the sine of the elevation. A white surface that faces up thus gets 0.3 of the horizon and 0.7 of the zenith.
   * Default: a bright zenith, a darker horizon and a dim ground, all nearly white.
   */
  void SetZenithColor(double r, double g, double b);
  vtkGetVector3Macro(ZenithColor, double);
  void SetHorizonColor(double r, double g, double b);
  vtkGetVector3Macro(HorizonColor, double);
  void SetGroundColor(double r, double g, double b);
  vtkGetVector3Macro(GroundColor, double);
  ///@}

  ///@{
  /**
   * Haze of daylight: the vertical optical thickness of air with its haze over that of air alone, 1 to 10. 1 is a sky
   * without haze, 2 to 3 a clear day, 6 a hazy one. Default: 2.5.
   */
  void SetTurbidity(double turbidity);
  vtkGetMacro(Turbidity, double);
  ///@}

  ///@{
  /**
   * Reflectance of the ground in daylight, 0 to 1. The ground fills the lower half of the image, lit by sun and sky.
   * Default: 0.3.
   */
  void SetGroundAlbedo(double r, double g, double b);
  vtkGetVector3Macro(GroundAlbedo, double);
  ///@}

  ///@{
  /**
   * The sun of daylight. Below the horizon it sends no light, and the sky is that of dusk, down to about -10 degrees.
   * Default: 40, 135.
   */
  void SetSunElevation(double degrees);
  vtkGetMacro(SunElevation, double);
  void SetSunAzimuth(double degrees);
  vtkGetMacro(SunAzimuth, double);
  ///@}

  /**
   * Put the sun where it is seen from a place at a time: the latitude north and longitude east in degrees, and a time from
   * 1950 to 2050 such as "2026-06-21T16:00:00Z" or "2026-06-21T18:00+02:00". Includes refraction by the air. Returns
   * false, with an error, for an impossible place or time. Michalsky 1988, The Astronomical Almanac's Algorithm for
   * Approximate Solar Position; within 0.01 degrees, apart from refraction.
   */
  bool SetSunByTime(double latitude, double longitude, const char* time);

  ///@{
  /**
   * Factor of the sunlight relative to the sky, 0 to 1000. The sun is no part of the image: it is a light. VTK divides
   * the light of lights, but not that of environments, by pi on physically based materials: pi is the right factor for a
   * scene of such materials. Default: 1, which is right for all others.
   */
  void SetSunStrength(double strength);
  vtkGetMacro(SunStrength, double);
  ///@}

  /**
   * The sun as a light, with the direction, colour and intensity of this sky, or nullptr if the sky has none.
   * It is switched off below the horizon. ApplyTo() adds it to the renderer.
   */
  vtkLight* GetSun();

  /**
   * Angular diameter of the sun's disc in degrees, 0.53.
   */
  static double GetSunDiameter() { return 0.53; }

  ///@{
  /**
   * Soft boxes in the sky, added to its radiance.
   */
  void AddSoftBox(vtkGISoftBox* box);
  void RemoveSoftBox(vtkGISoftBox* box);
  void RemoveAllSoftBoxes();
  int GetNumberOfSoftBoxes();
  vtkGISoftBox* GetSoftBox(int index); ///< nullptr if there is none
  ///@}

  ///@{
  /**
   * Directions of the world: up, and the bearing 0. North need not be level; where it is vertical, -z is used, or else
   * x. Default: (0, 0, 1), (0, 1, 0), as on a map.
   */
  void SetUp(double x, double y, double z);
  vtkGetVector3Macro(Up, double);
  void SetNorth(double x, double y, double z);
  vtkGetVector3Macro(North, double);
  ///@}

  ///@{
  /**
   * Degrees by which all azimuths are turned, without making the image again. Default: 0.
   */
  void SetRotation(double degrees);
  vtkGetMacro(Rotation, double);
  ///@}

  ///@{
  /**
   * Whether the sky, with its sun, follows the camera. Only the renderer's environment axes change per frame, never the
   * image. Default: false.
   */
  vtkSetMacro(FollowCamera, bool);
  vtkGetMacro(FollowCamera, bool);
  vtkBooleanMacro(FollowCamera, bool);
  ///@}

  ///@{
  /**
   * Whether ApplyTo() also shows the sky behind the scene, as a vtkSkybox. Default: false.
   */
  vtkSetMacro(Visible, bool);
  vtkGetMacro(Visible, bool);
  vtkBooleanMacro(Visible, bool);
  ///@}

  ///@{
  /**
   * Width of the image in pixels, a multiple of 4 from 16 to 2048; its height is half of that. VTK filters the image when
   * it changes. Default: 256.
   */
  void SetImageWidth(int width);
  vtkGetMacro(ImageWidth, int);
  ///@}

  /**
   * The image: three floats per pixel, lowest row first, made if the sky changed. Each change makes a new image.
   */
  vtkImageData* GetImage();

  ///@{
  /**
   * Radiance from a direction, from the nearest pixel; and irradiance of a surface whose normal points there.
   */
  void GetRadiance(double elevation, double azimuth, double rgb[3]);
  void GetIrradiance(double elevation, double azimuth, double rgb[3]);
  ///@}

  ///@{
  /**
   * Make the sky the renderer's environment: its texture, axes, image-based lighting with spherical harmonics, sun, and
   * skybox. It stays up to date, also with the camera, until RemoveFrom() restores what was there. The renderer keeps the
   * sky alive. A renderer has one sky at a time; remove the last one applied first. Applying a sky again makes it the
   * environment again, if the program set another one in the meantime.
   */
  void ApplyTo(vtkRenderer* renderer);
  void RemoveFrom(vtkRenderer* renderer);
  bool IsAppliedTo(vtkRenderer* renderer);
  ///@}

  /**
   * Bring a renderer up to date. This happens by itself when the renderer draws.
   */
  void UpdateFor(vtkRenderer* renderer);

protected:
  vtkGISkySource();
  ~vtkGISkySource() override;

private:
  vtkGISkySource(const vtkGISkySource&) = delete;
  void operator=(const vtkGISkySource&) = delete;

  friend class penumbra::SkyInstallation;
  penumbra::SkyInstallation* FindInstallation(vtkRenderer* renderer);
  void Forget(penumbra::SkyInstallation* installation);
  void GetCompass(double east[3], double north[3]);
  void ComputeAxes(vtkRenderer* renderer, double right[3], double up[3]);
  std::vector<double> DescribeImage();
  void Make();
  void UpdateSun();

  int Kind = UNIFORM;
  double Strength = 1.0;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double ZenithColor[3] = { 1.0, 1.02, 1.06 };
  double HorizonColor[3] = { 0.6, 0.6, 0.6 };
  double GroundColor[3] = { 0.25, 0.24, 0.23 };
  double Turbidity = 2.5;
  double GroundAlbedo[3] = { 0.3, 0.3, 0.3 };
  double SunElevation = 40.0;
  double SunAzimuth = 135.0;
  double SunStrength = 1.0;
  double Up[3] = { 0.0, 0.0, 1.0 };
  double North[3] = { 0.0, 1.0, 0.0 };
  double Rotation = 0.0;
  bool FollowCamera = false;
  bool Visible = false;
  int ImageWidth = 256;
  std::vector<vtkSmartPointer<vtkGISoftBox>> SoftBoxes;

  std::vector<double> MadeOf; ///< the numbers from which the image was made
  vtkSmartPointer<vtkImageData> Image;
  double SunAtGround[3] = { 0.0, 0.0, 0.0 }; ///< share of the sunlight
  vtkNew<vtkLight> Sun;
  std::vector<penumbra::SkyInstallation*> Installations;
};

#endif
