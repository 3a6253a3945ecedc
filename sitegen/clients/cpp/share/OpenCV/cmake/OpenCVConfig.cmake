# OpenCV is not available for pages. It is found as an empty package: programs that include its
# headers fail with a message that names it, and the other programs of the package are compiled.
include_guard(GLOBAL)
set(OpenCV_VERSION 4.6.0)
set(OpenCV_INCLUDE_DIRS "")
set(OpenCV_LIBS "")
foreach(_module
  calib3d core dnn features2d flann highgui imgcodecs imgproc ml objdetect photo stitching video videoio)
  if(NOT TARGET opencv_${_module})
    add_library(opencv_${_module} INTERFACE IMPORTED GLOBAL)
  endif()
  list(APPEND OpenCV_LIBS opencv_${_module})
endforeach()
set(OpenCV_LIBRARIES ${OpenCV_LIBS})
