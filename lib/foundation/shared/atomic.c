/* Changes of shared memory that happen at one instant for all processes. */

#include <caml/bigarray.h>
#include <caml/mlvalues.h>

/* If the number at place i is one, it becomes the other. What was written before is seen by whoever sees the new
   one. */
intnat scc_exchange_half(value halves, intnat i, intnat from, intnat to)
{
  int32_t expected = (int32_t) from;
  int32_t *at = (int32_t *) Caml_ba_data_val(halves) + i;
  return __atomic_compare_exchange_n(at, &expected, (int32_t) to, 0, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE);
}

value scc_exchange_half_boxed(value halves, value i, value from, value to)
{
  return Val_long(scc_exchange_half(halves, Long_val(i), Long_val(from), Long_val(to)));
}

value scc_release_half(value halves, intnat i, intnat number)
{
  __atomic_store_n((int32_t *) Caml_ba_data_val(halves) + i, (int32_t) number, __ATOMIC_RELEASE);
  return Val_unit;
}

value scc_release_half_boxed(value halves, value i, value number)
{
  return scc_release_half(halves, Long_val(i), Long_val(number));
}

intnat scc_exchange(value numbers, intnat i, intnat from, intnat to)
{
  intnat *at = (intnat *) Caml_ba_data_val(numbers) + i;
  return __atomic_compare_exchange_n(at, &from, to, 0, __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE);
}

value scc_exchange_boxed(value numbers, value i, value from, value to)
{
  return Val_long(scc_exchange(numbers, Long_val(i), Long_val(from), Long_val(to)));
}

/* Adds to the number at place i; the number before. */
intnat scc_fetch_and_add(value numbers, intnat i, intnat more)
{
  return __atomic_fetch_add((intnat *) Caml_ba_data_val(numbers) + i, more, __ATOMIC_ACQ_REL);
}

value scc_fetch_and_add_boxed(value numbers, value i, value more)
{
  return Val_long(scc_fetch_and_add(numbers, Long_val(i), Long_val(more)));
}

/* Puts a number in the place of another, which it returns: before whatever is read later, and after whatever was written
   before, as all processes see it. */
intnat scc_swap(value numbers, intnat i, intnat number)
{
  intnat before = __atomic_exchange_n((intnat *) Caml_ba_data_val(numbers) + i, number, __ATOMIC_SEQ_CST);
  __atomic_thread_fence(__ATOMIC_SEQ_CST);
  return before;
}

value scc_swap_boxed(value numbers, value i, value number)
{
  return Val_long(scc_swap(numbers, Long_val(i), Long_val(number)));
}

/* Reads and writes a number: what was written before it is seen by whoever reads it. */
intnat scc_acquire(value numbers, intnat i)
{
  return __atomic_load_n((intnat *) Caml_ba_data_val(numbers) + i, __ATOMIC_ACQUIRE);
}

value scc_acquire_boxed(value numbers, value i) { return Val_long(scc_acquire(numbers, Long_val(i))); }

value scc_release(value numbers, intnat i, intnat number)
{
  __atomic_store_n((intnat *) Caml_ba_data_val(numbers) + i, number, __ATOMIC_RELEASE);
  return Val_unit;
}

value scc_release_boxed(value numbers, value i, value number)
{
  return scc_release(numbers, Long_val(i), Long_val(number));
}
