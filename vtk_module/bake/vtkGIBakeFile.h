// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIBakeFile
 * @brief   baked light in VTK's files of images (.vti)
 *
 * A bake of any kind is one vtkImageData, whose text "format" in the field data tells which technique it is for.
 * vtkXMLImageDataReader and ParaView read the file, too. What goes wrong is said in one sentence by GetLastError(),
 * and not by messages of VTK.
 *
 * @sa vtkGITechnique::SetBake()
 */
#ifndef vtkGIBakeFile_h
#define vtkGIBakeFile_h

#include "vtkObject.h"
#include "vtkRenderingGIModule.h"

#include <string> // for the error

class vtkGIPass;
class vtkGITechnique;
class vtkImageData;

class VTKRENDERINGGI_EXPORT vtkGIBakeFile : public vtkObject
{
public:
  static vtkGIBakeFile* New();
  vtkTypeMacro(vtkGIBakeFile, vtkObject);

  /**
   * Read a file's image. Returns false where the file is none of baked light, or is damaged.
   */
  bool Read(const char* path, vtkImageData* bake);

  /**
   * Give a file's light to a technique. Returns false where it holds none for it.
   */
  bool Load(const char* path, vtkGITechnique* technique);

  /**
   * Give a file's light to the technique of a pass that it is for, and switch that on. Returns the technique, or
   * nullptr where there is none.
   */
  vtkGITechnique* Load(const char* path, vtkGIPass* pass);

  /**
   * Write an image, compressed, by another name first: whatever happens, there is the former file or the new one.
   */
  bool Write(const char* path, vtkImageData* bake);

  /**
   * Why the last call failed, or "".
   */
  const char* GetLastError();

protected:
  vtkGIBakeFile() = default;
  ~vtkGIBakeFile() override = default;

private:
  vtkGIBakeFile(const vtkGIBakeFile&) = delete;
  void operator=(const vtkGIBakeFile&) = delete;

  bool Refuse(const std::string& reason);
  bool Give(const char* path, vtkImageData* bake, vtkGITechnique* technique);

  std::string LastError;
};

#endif
