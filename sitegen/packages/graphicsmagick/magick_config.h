/* What a page has of the functions and libraries that GraphicsMagick can use. */
#define QuantumDepth 16 /* as in Debian */
#define HasPNG 1
#define HasZLIB 1

#define HAS_C__func__ 1
#define HAS_CPP__func__ 1
#define HAVE_ATOLL 1
#define HAVE_CLOCK_GETTIME 1
#define HAVE_COSF 1
#define HAVE_DECL_PREAD 1
#define HAVE_DECL_PWRITE 1
#define HAVE_DECL_STRLCPY 1
#define HAVE_DECL_VSNPRINTF 1
#define HAVE_DEV_URANDOM 1
#define HAVE_FABSF 1
#define HAVE_FSEEKO 1
#define HAVE_GETPID 1
#define HAVE_LOCALTIME_R 1
#define HAVE_LOGF 1
#define HAVE_POSIX_MEMALIGN 1
#define HAVE_PREAD 1
#define HAVE_PTHREAD 1
#define HAVE_PWRITE 1
#define HAVE_SINF 1
#define HAVE_SQRTF 1
#define HAVE_STDINT_H 1
#define HAVE_STRERROR 1
#define HAVE_STRLCAT 1
#define HAVE_STRLCPY 1
#define HAVE_STRTOLL 1
#define HAVE_SYSCONF 1
#define HAVE_SYS_RESOURCE_H 1
#define HAVE_SYS_TIMES_H 1
#define HAVE_TIMES 1
#define HAVE_VSNPRINTF 1
#define HAVE_VSPRINTF 1
#define HAVE__EXIT 1
#define SETJMP_IS_THREAD_SAFE 1
#define SIZEOF_SIGNED_LONG 4
#define X_DISPLAY_MISSING 1

/* Where it would look for its own files, of which pages have none. */
#define UseInstalledMagick 1
#define MagickLibConfigPath "/usr/lib/GraphicsMagick/config/"
#define MagickShareConfigPath "/usr/share/GraphicsMagick/config/"
