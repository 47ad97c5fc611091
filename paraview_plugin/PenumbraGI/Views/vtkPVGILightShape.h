// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVGILightShape
 * @brief   the shape of one of ParaView's lights, as an object of its own
 *
 * ParaView's proxy of a light can only call methods of its class, which has none for shapes. This object belongs to a
 * part of that proxy, or to a proxy beside it. When it is deleted, the light has no shape again.
 *
 * @sa vtkGILightShape, vtkSMGILightShapeProxy
 */
#ifndef vtkPVGILightShape_h
#define vtkPVGILightShape_h

#include "vtkObject.h"
#include "vtkPenumbraParaViewModule.h" // for the export macro
#include "vtkSmartPointer.h"           // for the light

class vtkLight;

class VTKPENUMBRAPARAVIEW_EXPORT vtkPVGILightShape : public vtkObject
{
public:
  static vtkPVGILightShape* New();
  vtkTypeMacro(vtkPVGILightShape, vtkObject);

  /**
   * The light whose shape this is.
   */
  void SetLight(vtkLight* light);

  /**
   * One of vtkGILightShape::Shapes.
   */
  void SetShape(int shape);

  ///@{
  /**
   * Angular diameter of a directional light in degrees; radius of a sphere or disc, width and height of a rectangle in
   * world units; rotation of a rectangle in degrees.
   */
  void SetAngle(double degrees);
  void SetRadius(double radius);
  void SetSize(double width, double height);
  void SetTurn(double degrees);
  ///@}

protected:
  vtkPVGILightShape();
  ~vtkPVGILightShape() override;

private:
  vtkPVGILightShape(const vtkPVGILightShape&) = delete;
  void operator=(const vtkPVGILightShape&) = delete;

  void Apply();
  void Clear();

  vtkSmartPointer<vtkLight> Light;
  int Shape = 0;
  double Angle = 5.0;
  double Radius = 1.0;
  double Size[2] = { 1.0, 1.0 };
  double Turn = 0.0;
};

#endif
