// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMGILightShapeProxy.h"

#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMGILightShapeProxy);

void vtkSMGILightShapeProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// The server creates a proxy together with its parts, which do not know what they are parts of. A property that names
// the light would make the light keep itself alive.
void vtkSMGILightShapeProxy::UpdateVTKObjects()
{
  vtkSMProxy* light = this->GetParentProxy();
  if (!this->HasLight && light && light->GetObjectsCreated())
  {
    this->HasLight = true;
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "SetLight" << VTKOBJECT(light)
           << vtkClientServerStream::End;
    this->ExecuteStream(stream);
  }
  this->Superclass::UpdateVTKObjects();
}
