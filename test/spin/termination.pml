/* When an exploration without levels has ended: Safra's algorithm (E. W. Dijkstra, EWD998, 1987), as owners use it.

   Each process counts the messages that it has sent, less those that it has received. A token goes round, from 0 to
   the last process and so on down to 0; it carries the sum of the counters, and passes on from processes that have
   nothing to do and nothing to receive. A process that received something since the token last left it makes the token black. Process 0
   ends the exploration if the token has come back white, it has received nothing since, and the sum is zero.

   Claims: at the end nobody has anything to do and no message is under way; and the end is always found.

   -DNO_COUNT leaves the sum out; -DNO_COLOUR leaves the colour out. Each of them is a fault that spin finds. */

#define PROCESSES 3
#define MESSAGES 3

chan on_the_way[PROCESSES] = [MESSAGES] of { bit };   /* to each process */
chan arrived[PROCESSES] = [MESSAGES] of { bit };
chan token[PROCESSES] = [1] of { int, bit };
bit works[PROCESSES];
byte sent, under_way;
bool ended;

#ifdef NO_COUNT
#define IS_ZERO(sum) true
#else
#define IS_ZERO(sum) ((sum) == 0)
#endif

#ifdef NO_COLOUR
#define IS_WHITE(black) true
#else
#define IS_WHITE(black) (black == 0)
#endif

proctype process(byte me) {
  int count, sum;
  bit black, black_token;
  byte other;

  do
  :: ended -> break
  :: works[me] && sent < MESSAGES ->        /* finds a state of another process */
     select(other : 1 .. PROCESSES - 1);
     atomic {
       if
       :: sent < MESSAGES -> on_the_way[(me + other) % PROCESSES]!1; count++; sent++; under_way++
       :: else
       fi
     }
  :: works[me] -> works[me] = 0             /* has nothing more to do */
  :: atomic { arrived[me]?_ -> count--; under_way--; black = 1; works[me] = 1 }
  :: me != 0 && !works[me] && empty(arrived[me]) && nempty(token[me]) ->
     atomic {
       token[me]?sum,black_token;
       token[me - 1]!sum + count,(black | black_token);
       black = 0
     }
  :: me == 0 && !works[me] && empty(arrived[me]) && nempty(token[0]) ->
     atomic {
       token[0]?sum,black_token;
       if
       :: IS_WHITE(black) && IS_WHITE(black_token) && IS_ZERO(sum + count) ->
          assert(under_way == 0 && works[0] + works[1] + works[2] == 0);
          ended = true
       :: else -> black = 0; token[PROCESSES - 1]!0,0
       fi
     }
  od
}

proctype wire(byte who) {
end:
  do
  :: atomic { on_the_way[who]?_ -> arrived[who]!1 }
  od
}

init {
  byte k;
  atomic {
    works[0] = 1;
    token[0]!0,1;
    do
    :: k < PROCESSES -> run process(k); run wire(k); k++
    :: else -> break
    od
  }
}

ltl ends { <> ended }
