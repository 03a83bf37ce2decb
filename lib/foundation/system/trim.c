/* Memory that the program has freed, given back to the system. */

#include <caml/mlvalues.h>

#include <stdlib.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

/* OCaml 5 takes large blocks from malloc, which keeps what is freed of them. */
value scc_trim(value unit)
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  return unit;
}
