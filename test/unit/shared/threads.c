/* Threads in the place of processes call the stubs of lib/foundation/shared at once, under sanitisers. Who sees what
   a stub has written sees what was written before it: a sanitiser of threads finds where that need not be so. */

#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CAML_NAME_SPACE
#include "atomic.c"

#define THREADS 8
#define ROUNDS 20000
#define FEW 300
#define KEYS 512

/* A table as bigarrays have it. */
struct table {
  value operations;
  struct caml_ba_array array;
};

static struct table make(long count, long size)
{
  struct table t;
  memset(&t, 0, sizeof t);
  t.array.data = calloc(count, size);
  return t;
}

#define TABLE(t) ((value) & (t).array - sizeof(value))
#define NUMBERS(t) ((intnat *) (t).array.data)
#define HALVES(t) ((int32_t *) (t).array.data)

static struct table numbers, index_, keys, counters;
static int who[THREADS];

static void wrong(const char *what)
{
  fprintf(stderr, "%s\n", what);
  exit(1);
}

static void all_at_once(void *(*work)(void *) )
{
  pthread_t threads[THREADS];
  for (int i = 0; i < THREADS; i++) {
    who[i] = i;
    if (pthread_create(&threads[i], NULL, work, &who[i])) wrong("no thread");
  }
  for (int i = 0; i < THREADS; i++) pthread_join(threads[i], NULL);
}

/* Numbers are given once each. */
static void *count(void *argument)
{
  (void) argument;
  for (int round = 0; round < ROUNDS; round++) NUMBERS(keys)[scc_fetch_and_add(TABLE(counters), 0, 1)]++;
  return NULL;
}

/* A key is written before its number is put into a slot, and is there for who finds it. */
static void *insert(void *argument)
{
  int me = *(int *) argument;
  unsigned seed = 1 + me;
  for (int round = 0; round < ROUNDS; round++) {
    intnat key = rand_r(&seed) % KEYS, id = me * ROUNDS + round + 1;
    NUMBERS(keys)[id] = key;
    if (!scc_exchange_half(TABLE(index_), key, 0, id)) {
      intnat there = __atomic_load_n(HALVES(index_) + key, __ATOMIC_ACQUIRE);
      if (NUMBERS(keys)[there] != key) wrong("a number is seen before its key");
    }
  }
  return NULL;
}

/* One writes a message and then says so; all others read it once they see that. */
static void *pass_on(void *argument)
{
  int me = *(int *) argument;
  for (intnat round = 1; round <= FEW; round++)
    if (round % THREADS == me) {
      while (scc_acquire(TABLE(counters), 1) != THREADS * (round - 1)) sched_yield();
      NUMBERS(numbers)[0] = 7 * round;
      HALVES(index_)[KEYS] = (int32_t) round;
      scc_release(TABLE(counters), 2, round);
      scc_fetch_and_add(TABLE(counters), 1, 1);
    } else {
      while (scc_acquire(TABLE(counters), 2) < round) sched_yield();
      if (NUMBERS(numbers)[0] != 7 * round || HALVES(index_)[KEYS] != round)
        wrong("a message is seen before it is there");
      scc_fetch_and_add(TABLE(counters), 1, 1);
    }
  return NULL;
}

/* Two put a number each and look for that of the other: one of them at least sees it. */
static pthread_barrier_t barrier;

static void *look(void *argument)
{
  int me = *(int *) argument;
  if (me < 2)
    for (int round = 0; round < FEW; round++) {
      scc_release(TABLE(numbers), 8 + me, 0);
      pthread_barrier_wait(&barrier);
      scc_swap(TABLE(numbers), 8 + me, 1);
      scc_release(TABLE(numbers), 16 + me, scc_acquire(TABLE(numbers), 8 + (1 - me)));
      pthread_barrier_wait(&barrier);
      if (!scc_acquire(TABLE(numbers), 16) && !scc_acquire(TABLE(numbers), 17)) wrong("neither sees the other");
      pthread_barrier_wait(&barrier);
    }
  return NULL;
}

/* The greatest of all numbers stays, as by Shared_memory.raise_to. */
static void *raise(void *argument)
{
  unsigned seed = 1 + *(int *) argument;
  for (int round = 0; round < ROUNDS; round++) {
    intnat number = rand_r(&seed) % 1000000, known;
    do known = scc_acquire(TABLE(counters), 3);
    while (known < number && !scc_exchange(TABLE(counters), 3, known, number));
    if (scc_acquire(TABLE(counters), 3) < number) wrong("a greater number is gone");
    scc_release_half(TABLE(index_), KEYS + 1 + *(int *) argument, (int32_t) number);
  }
  return NULL;
}

int main(void)
{
  numbers = make(64, sizeof(intnat));
  counters = make(64, sizeof(intnat));
  index_ = make(KEYS + 64, sizeof(int32_t));
  keys = make(THREADS * ROUNDS + 1, sizeof(intnat));
  pthread_barrier_init(&barrier, NULL, 2);
  all_at_once(count);
  for (long id = 0; id < THREADS * ROUNDS; id++)
    if (NUMBERS(keys)[id] != 1) wrong("a number was given twice");
  all_at_once(insert);
  scc_release(TABLE(counters), 1, 0);
  all_at_once(pass_on);
  all_at_once(look);
  all_at_once(raise);
  puts("as it should be");
  return 0;
}
