(** Where two states differ, whatever the states that are not known can do, and a formula that says so.

    Two positions differ iff one of them has a move such that it differs, afterwards, from every position by
    which the other can answer; the least such relation. An unknown state may answer anything, so what is found
    is found for certain. The moves and their answers are those of the relation:

    - [Strong]: an action against the same action; in a timed system also the passing of the longest time for
      which neither side meets an instant of its own ({!System.common}). So longer passings are split at the
      other side's instants, and timed bisimilarity over dense time is decided: within such a time nothing can
      happen on either side, and where one is on the way has been decided at its begin.
    - [Weak]: an action against [tau* a tau*] (a silent one against [tau*]).
    - [Branching]: an action against [tau* a] such that the position before a does not differ from the mover's
      old one, and the one after from its new one; a silent action may also be answered by none. *)

type kind = Refine.kind = Strong | Branching | Weak

type outcome =
  | Differ of Formula.t option
  (** certainly holds of the first and possibly holds not of the second: checked by the caller. [None] when
      it would be larger than {!most_parts}. *)
  | Alike  (** no certain difference: a proof of bisimilarity when everything is known *)
  | Too_large  (** more than {!most_pairs} pairs, or more questions about them than allowed *)

val most_pairs : int
val most_parts : int

val to_decide : int
(** Questions for up to a minute or two. *)

val to_explain : int
(** Questions for a few seconds: about graphs that are known to differ. *)

val play :
  Effort.t ->
  kind ->
  System.t ->
  most:int ->
  same:(System.position -> System.position -> bool) ->
  Formula.store ->
  System.position ->
  System.position ->
  outcome
(** [same] may say of positions that they are known to be bisimilar. Raises {!Effort.Exhausted}. *)
