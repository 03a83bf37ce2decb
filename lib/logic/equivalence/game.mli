(** The bisimulation game: it decides if two states differ, whatever unknown states can do, and finds a formula
    that shows the difference.

    Two positions differ iff one of them has a move after which its position differs from every position by which
    the other can answer. This is the least such relation. An unknown state may answer any move, so a difference
    that is found is certain. The moves and their answers are those of the relation:

    - [Strong]: an action is answered by the same action. In a timed system there is also the passing of the
      longest time for which neither side meets an instant of its own ({!System.common}). So longer passings are
      split at the instants of the other side, and timed bisimilarity over dense time is decided. Within such a
      time nothing can happen on either side, and the way was chosen at its beginning.
    - [Weak]: an action is answered by [tau* a tau*] (a silent one by [tau*]).
    - [Branching]: an action is answered by [tau* a]. The position before a must not differ from the old one of the
      mover, and the position after it not from the new one. A silent action may also be answered by no move. *)

type kind = Refine.kind = Strong | Branching | Weak

type outcome =
  | Differ of Modal_formula.t option
  (** The two differ. The formula certainly holds for the first, and certainly not for the second; the caller
      checks it. [None] if it would have more than {!most_parts} parts, or took too many steps to find. *)
  | Alike  (** no certain difference: a proof of bisimilarity if all states are known *)
  | Too_large  (** more than {!most_pairs} pairs, or more comparisons of positions than allowed *)

val most_pairs : int
(** 400 000: the greatest number of pairs of positions in a game. *)

val most_parts : int
(** 2 000: the greatest number of parts of a formula, and of steps of a trace that becomes a formula. *)

val to_decide : int
(** 1 000 000 000 comparisons of positions, which take up to a minute or two: for graphs that may be equivalent. *)

val to_explain : int
(** 50 000 000 comparisons of positions, which take a few seconds: for graphs that are known to differ. *)

val play :
  Effort.t ->
  kind ->
  System.t ->
  most:int ->
  same:(System.position -> System.position -> bool) ->
  Modal_formula.store ->
  System.position ->
  System.position ->
  outcome
(** [play effort kind m ~most ~same store p q] plays the game from the positions [p] and [q] of [m], with at most
    [most] comparisons of positions. [same] may be true for positions that are known to be bisimilar. Raises
    {!Effort.Exhausted}. *)
