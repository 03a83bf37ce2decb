/* The table of pairs that several processes fill (lib/logic/graph_search/pairs.ml, put_shared).

   A key stands in flat, at its number; a slot of the index holds the number. Whoever finds no key takes a number,
   writes the key there, and then exchanges the free slot for the number, at one instant. If another process was
   first, it looks on from that slot, and keeps its number for the next key.

   Claims: a number that is found has the key that was looked for, and equal keys have equal numbers.

   -DKEEPS_NUMBERS has two processes that look twice, instead of three that look once.
   -DCHECK_THEN_WRITE looks at the slot and writes it at two instants; -DNUMBER_FIRST writes the slot before the key.
   Each of them is a fault that spin finds. */

#ifdef KEEPS_NUMBERS
#define PROCESSES 2
#define ROUNDS 2      /* lookups of each process */
#else
#define PROCESSES 3
#define ROUNDS 1
#endif
#define KEYS 2
#define SLOTS 3

byte flat[PROCESSES * ROUNDS];
byte slots[SLOTS];    /* 0 is free; else a number, plus one */
byte taken;           /* numbers that processes have taken */
byte number_of[KEYS + 1];

proctype process() {
  byte key, i, entry, own, id, round;

again:
  if
  :: round == ROUNDS -> goto done
  :: else -> round++
  fi;
  select(key : 1 .. KEYS);
  i = 0;                              /* all keys begin with one slot: the worst case */

probe:
  entry = slots[i];
  if
  :: entry == 0 -> goto vacant
  :: else
  fi;
  if
  :: flat[entry - 1] == key -> id = entry; goto found
  :: else -> i = (i + 1) % SLOTS; goto probe
  fi;

vacant:
  if
  :: own == 0 -> atomic { taken++; own = taken }
  :: else
  fi;
#ifndef NUMBER_FIRST
  flat[own - 1] = key;
#endif
#ifdef CHECK_THEN_WRITE
  if
  :: slots[i] != 0 -> goto probe
  :: else
  fi;
  slots[i] = own;
#else
  atomic {
    if
    :: slots[i] != 0 -> goto probe
    :: else -> slots[i] = own
    fi
  };
#endif
#ifdef NUMBER_FIRST
  flat[own - 1] = key;
#endif
  id = own;
  own = 0;

found:
  atomic {
    assert(flat[id - 1] == key);
    assert(number_of[key] == 0 || number_of[key] == id);
    number_of[key] = id
  };
  goto again;

done:
  skip
}

init {
  byte k;
  atomic {
    do
    :: k < PROCESSES -> run process(); k++
    :: else -> break
    od
  }
}
