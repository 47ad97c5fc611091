// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGILightShape
 * @brief   the size and shape of a vtkLight
 *
 * A light with a shape casts soft shadows, and lights from its whole area. The shape is stored in the light's
 * vtkInformation, so that it lives as long as the light. Scenes without Penumbra ignore it.
 *
 * Directional lights can have an angle; positional lights can be spheres, discs and rectangles. A shape of the other
 * kind of light has no effect. Headlights have no shadows and no shape. Discs and rectangles shine to one side, from
 * the light's position toward its focal point, and are as bright from all directions (Lambert's emitters). The shapes
 * themselves are invisible, as VTK's lights are, and cast no shadows.
 *
 * The strength of a light does not depend on its shape. A point at distance d from the centre sees a disc of radius r,
 * or a rectangle of area A = pi r^2, with radiance pi c i D^2 / (A a(D)), where c is the colour, i the intensity, a()
 * VTK's attenuation (constant, linear, quadratic), and D^2 = d^2 + r^2. So the light gives the same irradiance from
 * far away on its axis as a point light, and a disc gives a point on its axis the irradiance of a point light at the
 * distance of its rim. With quadratic attenuation alone the radiance is the same everywhere, as that of real lamps. A
 * cone darkens a disc or rectangle as it does a point light. A sphere of radius r has radiance c i d^2 / (r^2 a(d)),
 * and gives the same irradiance as a point light wherever all of it is above the horizon, as does a directional light
 * with an angle.
 *
 * vtkLight::DeepCopy() copies the shape with the rest of the information; Copy() copies the shape alone. A light that
 * shares another one's vtkInformation shares its shape.
 *
 * All functions do nothing, with an error message, where a value is negative or not finite. A value of zero makes the
 * light a point.
 */
#ifndef vtkGILightShape_h
#define vtkGILightShape_h

#include "vtkObject.h"
#include "vtkRenderingGIModule.h"

class vtkInformationDoubleVectorKey;
class vtkInformationIntegerKey;
class vtkLight;

class VTKRENDERINGGI_EXPORT vtkGILightShape : public vtkObject
{
public:
  static vtkGILightShape* New();
  vtkTypeMacro(vtkGILightShape, vtkObject);

  /**
   * Shapes. A light without a shape has the angle or radius that the technique gives to all lights, such as
   * light-angle and light-radius of shadow-maps. A point is a light without size, whatever the technique says.
   */
  enum Shapes
  {
    NONE,
    POINT,
    ANGLE,
    SPHERE,
    DISC,
    RECTANGLE
  };

  /**
   * Take a light's shape away.
   */
  static void Remove(vtkLight* light);

  /**
   * Make a light a point, with hard shadows.
   */
  static void SetPoint(vtkLight* light);

  /**
   * Give a directional light an angular diameter in degrees, 0 to 90: 0.53 for the sun.
   */
  static void SetAngle(vtkLight* light, double degrees);

  /**
   * Make a positional light a sphere with a radius in world units.
   */
  static void SetSphere(vtkLight* light, double radius);

  /**
   * Make a positional light a disc with a radius in world units, that faces the light's focal point.
   */
  static void SetDisc(vtkLight* light, double radius);

  /**
   * Make a positional light a rectangle that faces the light's focal point, with width and height in world units. Its
   * width is horizontal: perpendicular to the light's direction and to the y axis, or to the z axis if the light shines
   * along y. turn: angle in degrees by which it is rotated from there, clockwise as the light sees it. A light that
   * follows the camera has the camera's axes.
   */
  static void SetRectangle(vtkLight* light, double width, double height, double turn = 0.0);

  /**
   * Copy the shape of one light to another.
   */
  static void Copy(vtkLight* from, vtkLight* to);

  /**
   * A light's shape, one of Shapes.
   */
  static int GetShape(vtkLight* light);

  /**
   * Angular diameter of a directional light in degrees; 0 for other shapes.
   */
  static double GetAngle(vtkLight* light);

  /**
   * Radius of a sphere or disc in world units; 0 for other shapes.
   */
  static double GetRadius(vtkLight* light);

  ///@{
  /**
   * Size of a rectangle in world units, and its rotation in degrees; 0 for other shapes.
   */
  static double GetWidth(vtkLight* light);
  static double GetHeight(vtkLight* light);
  static double GetTurn(vtkLight* light);
  ///@}

  ///@{
  /**
   * Keys under which the shape is stored: one of Shapes, and its angle, its radius, or its width, height and turn. Call
   * the light's Modified() after setting them.
   */
  static vtkInformationIntegerKey* SHAPE();
  static vtkInformationDoubleVectorKey* SIZE();
  ///@}

protected:
  vtkGILightShape() = default;
  ~vtkGILightShape() override = default;

private:
  vtkGILightShape(const vtkGILightShape&) = delete;
  void operator=(const vtkGILightShape&) = delete;
};

#endif
