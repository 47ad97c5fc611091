// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGIBakeFile
 * @brief   reads and writes baked light in VTK's image files (.vti)
 *
 * A bake of any kind is one vtkImageData. The text "format" in its field data tells which technique it is for.
 * vtkXMLImageDataReader and ParaView read the file too. GetLastError() says in one sentence what went wrong; VTK
 * prints nothing.
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
   * Read a file's image. Returns false where the file holds no image, or is damaged.
   */
  bool Read(const char* path, vtkImageData* bake);

  /**
   * Give a file's light to a technique. Returns false where the technique does not take it.
   */
  bool Load(const char* path, vtkGITechnique* technique);

  /**
   * Give a file's light to the technique of the pass that takes its format, and switch that technique on. Returns
   * the technique, or nullptr on failure.
   */
  vtkGITechnique* Load(const char* path, vtkGIPass* pass);

  /**
   * Write an image, compressed. The file is complete or unchanged, whatever happens: it is written under another name
   * first.
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
