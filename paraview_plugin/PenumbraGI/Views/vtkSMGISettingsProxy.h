// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMGISettingsProxy
 * @brief   client side of vtkPVGISettings, which applies presets
 *
 * Setting the property GIPreset sets every switch and parameter to the preset's value, and then GIPreset
 * back to "choose". Thus a state file holds only the values, and cannot contradict itself.
 *
 * @sa vtkPVGISettings
 */
#ifndef vtkSMGISettingsProxy_h
#define vtkSMGISettingsProxy_h

#include "vtkPenumbraParaViewModule.h" // for the export macro
#include "vtkSMProxy.h"

class VTKPENUMBRAPARAVIEW_EXPORT vtkSMGISettingsProxy : public vtkSMProxy
{
public:
  static vtkSMGISettingsProxy* New();
  vtkTypeMacro(vtkSMGISettingsProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMGISettingsProxy() = default;
  ~vtkSMGISettingsProxy() override = default;

private:
  vtkSMGISettingsProxy(const vtkSMGISettingsProxy&) = delete;
  void operator=(const vtkSMGISettingsProxy&) = delete;

  void ApplyPreset(int index);
};

#endif
