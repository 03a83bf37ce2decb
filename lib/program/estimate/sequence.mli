(** An estimation by one run after the other, in this process. Its answers are those of [scc estimate] with any
    number of processes, since each run depends on its number alone. *)

val in_turn : Path.t list -> Path.t list list
(** [in_turn paths] are the paths in groups that have runs of their own. Questions that no time decides may need
    long runs. The others come first: so their answers are known, whatever becomes of the long runs. *)

val answers :
  Estimation.aim -> Sample.plan -> seed:int64 -> stopped:(unit -> bool) -> Estimation.answer list
(** [answers aim plan ~seed ~stopped] makes as many runs as are needed, and has an answer for each path, in order.
    If [stopped ()] is true, no more runs are made, and the answers rest on those that were. *)
