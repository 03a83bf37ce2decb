/* When owners that go in no order have nothing left to do (lib/program/owners/termination.ml, free.ml): a model for SPIN.
   Messages with states are bounded by WORK, all together; an owner that receives one has something to do. The token goes
   from owner to owner. `over` may be told only when nothing is left to do, and nothing is under way.

   With -DNO_SUM the sum of the token does not count, with -DNO_COLOUR the colours do not, and with -DBUSY a token is
   passed on by an owner that has something to do. Each of these tells too early. */

#ifndef OWNERS
#define OWNERS 3
#endif
#ifndef WORK
#define WORK 4
#endif

typedef owner {
  short balance;  /* messages sent, less those received */
  bool black;
  bool busy
}

owner owners[OWNERS];
chan states[OWNERS] = [WORK] of { bit };
chan token[OWNERS] = [1] of { short, bool };  /* the sum, and whether it is black */
byte sent = 0;
bool over = false;

/* A message may be under way for as long as it likes; with -DPROMPT, it is received before the token is passed on. */
#ifdef BUSY
#define rests true
#else
#ifdef PROMPT
#define rests (!owners[me].busy && empty(states[me]))
#else
#define rests (!owners[me].busy)
#endif
#endif

inline check_over() {
  byte k = 0;
  do
  :: k < OWNERS -> assert(!owners[k].busy && empty(states[k])); k++
  :: else -> break
  od
}

proctype work(byte me) {
  byte to;
  short sum;
  bool black, begun = false;
  do
  :: over -> break
  /* A message is received. */
  :: atomic { !over && nempty(states[me]) ->
       states[me]?_; owners[me].balance--; owners[me].black = true; owners[me].busy = true }
  /* Something is found for another owner. */
  :: atomic { !over && owners[me].busy && sent < WORK ->
       select(to : 1 .. OWNERS - 1);
       states[(me + to) % OWNERS]!0; owners[me].balance++; sent++ }
  :: atomic { !over && owners[me].busy -> owners[me].busy = false }
  /* The first owner begins, once. */
  :: atomic { !over && me == 0 && !begun && rests ->
       begun = true; owners[0].black = false; token[1]!0,false }
  :: atomic { !over && me != 0 && nempty(token[me]) && rests ->
       token[me]?sum,black;
       token[(me + 1) % OWNERS]!sum + owners[me].balance,(black || owners[me].black);
       owners[me].black = false }
  :: atomic { !over && me == 0 && begun && nempty(token[0]) && rests ->
       token[0]?sum,black;
       if
#ifdef NO_SUM
       :: !black && !owners[0].black ->
#else
#ifdef NO_COLOUR
       :: sum + owners[0].balance == 0 ->
#else
       :: !black && !owners[0].black && sum + owners[0].balance == 0 ->
#endif
#endif
          check_over(); over = true
       :: else -> owners[0].black = false; token[1]!0,false
       fi }
  od
}

init {
  byte k;
  atomic {
    owners[0].busy = true;
    k = 0;
    do
    :: k < OWNERS -> run work(k); k++
    :: else -> break
    od
  }
}

/* If owners do what they can, and messages are received, it ends. */
ltl ends { <> over }
