/* How a process that waits is woken (lib/exploration/parallel/served.ml).

   Whoever waits says so, looks once more, and sleeps until a byte arrives. Whoever has written something looks
   whether the other one waits, and sends a byte then. What a process writes is seen by itself at once, and by the
   other one later, in order, as processors store (total store order). An exchange (swap) waits until all that was
   written before is seen.

   Claim: all requests are answered; nobody sleeps for ever.

   -DNO_SECOND_LOOK sleeps without looking again; -DNO_FENCE exchanges as an ordinary write and read do. Each of
   them is a fault that spin finds. */

#define REQUESTS 2
#define MAIN 0
#define WORKER 1

/* Places: that of the request (1 asked, 2 answered), and whether each process waits. */
#define SLOT 0
#define BELL(who) (1 + who)
#define PLACES 3

byte memory[PLACES];
chan written[2] = [4] of { byte, byte };   /* not yet seen by the other process */
byte last[6];                              /* what a process has written last at a place */
byte pending[6];                           /* how often that is not yet seen */
chan bytes[2] = [8] of { bit };            /* to each process */

#define MINE(who, place) (PLACES * who + place)

inline store(who, place, x) {
  atomic { written[who]!place,x; last[MINE(who, place)] = x; pending[MINE(who, place)]++ }
}

inline load(who, place, x) {
  atomic {
    if
    :: pending[MINE(who, place)] > 0 -> x = last[MINE(who, place)]
    :: else -> x = memory[place]
    fi
  }
}

inline swap(who, place, x, before) {
#ifdef NO_FENCE
  load(who, place, before);
  store(who, place, x);
#else
  atomic { empty(written[who]) -> before = memory[place]; memory[place] = x }
#endif
}

proctype seen(byte who) {
  byte place, x;
end:
  do
  :: atomic { written[who]?place,x -> memory[place] = x; pending[MINE(who, place)]--; place = 0; x = 0 }
  od
}

/* Waits until the slot holds x. */
inline await(who, x) {
  do
  :: load(who, SLOT, now);
     if
     :: now == x -> break
     :: else
     fi;
     swap(who, BELL(who), 1, before);
#ifndef NO_SECOND_LOOK
     load(who, SLOT, now);
     if
     :: now == x -> break
     :: else
     fi;
#endif
     bytes[who]?_
  od
}

inline tell(who, other, x) {
  store(who, SLOT, x);
  swap(who, BELL(other), 0, before);
  if
  :: before == 1 -> bytes[other]!1
  :: else
  fi
}

active proctype asks() {
  byte now, before, k;
  run seen(MAIN);
  do
  :: k < REQUESTS -> tell(MAIN, WORKER, 1); await(MAIN, 2); k++
  :: else -> break
  od
}

active proctype answers() {
  byte now, before, k;
  run seen(WORKER);
  do
  :: k < REQUESTS -> await(WORKER, 1); tell(WORKER, MAIN, 2); k++
  :: else -> break
  od
}
