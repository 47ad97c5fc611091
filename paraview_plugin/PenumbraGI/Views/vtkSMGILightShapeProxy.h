// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMGILightShapeProxy
 * @brief   client side of vtkPVGILightShape, which gives the shape its light
 *
 * As a part of the proxy of one of ParaView's lights it shapes that light. As a proxy of its own it shapes the light that
 * its property Light names, which is for lights that are older than the plugin.
 *
 * @sa vtkPVGILightShape
 */
#ifndef vtkSMGILightShapeProxy_h
#define vtkSMGILightShapeProxy_h

#include "vtkPenumbraParaViewModule.h" // for the export macro
#include "vtkSMProxy.h"

class VTKPENUMBRAPARAVIEW_EXPORT vtkSMGILightShapeProxy : public vtkSMProxy
{
public:
  static vtkSMGILightShapeProxy* New();
  vtkTypeMacro(vtkSMGILightShapeProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMGILightShapeProxy() = default;
  ~vtkSMGILightShapeProxy() override = default;

private:
  vtkSMGILightShapeProxy(const vtkSMGILightShapeProxy&) = delete;
  void operator=(const vtkSMGILightShapeProxy&) = delete;

  bool HasLight = false;
};

#endif
