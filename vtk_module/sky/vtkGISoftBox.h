// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGISoftBox
 * @brief   a bright rectangle or disc in a sky, as a photographer's soft box far away
 *
 * Its power is its radiance times the solid angle of the box with hard edges, however soft the edges are. Angles are in
 * degrees. Numbers out of range are limited; those that are not finite are refused.
 *
 * @sa vtkGISkySource::AddSoftBox()
 */
#ifndef vtkGISoftBox_h
#define vtkGISoftBox_h

#include "vtkObject.h"
#include "vtkRenderingGIModule.h"

class VTKRENDERINGGI_EXPORT vtkGISoftBox : public vtkObject
{
public:
  static vtkGISoftBox* New();
  vtkTypeMacro(vtkGISoftBox, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Direction of the middle: the elevation above the horizon, -90 to 90, and the azimuth as vtkGISkySource defines it.
   * Default: 45, 0.
   */
  void SetElevation(double degrees);
  vtkGetMacro(Elevation, double);
  void SetAzimuth(double degrees);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /**
   * Angular width and height of a rectangle, 0.1 to 170. Default: 40, 40.
   */
  void SetWidth(double degrees);
  vtkGetMacro(Width, double);
  void SetHeight(double degrees);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Angular radius of a disc, up to 180; 0 stands for a rectangle. Default: 0.
   */
  void SetRadius(double degrees);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Radiance and colour, whose product is added to that of the sky. Default: 10, white.
   */
  void SetRadiance(double radiance);
  vtkGetMacro(Radiance, double);
  void SetColor(double r, double g, double b);
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /**
   * Half the width of the blurred edge, as a share of half the box: 0 for a hard edge, up to 1. Default: 0.3.
   */
  void SetSoftness(double share);
  vtkGetMacro(Softness, double);
  ///@}

  /**
   * Solid angle in steradians: 4 asin(sin(width / 2) sin(height / 2)), or 2 pi (1 - cos(radius)).
   */
  double GetSolidAngle();

protected:
  vtkGISoftBox() = default;
  ~vtkGISoftBox() override = default;

private:
  vtkGISoftBox(const vtkGISoftBox&) = delete;
  void operator=(const vtkGISoftBox&) = delete;

  double Elevation = 45.0;
  double Azimuth = 0.0;
  double Width = 40.0;
  double Height = 40.0;
  double Radius = 0.0;
  double Radiance = 10.0;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double Softness = 0.3;
};

#endif
