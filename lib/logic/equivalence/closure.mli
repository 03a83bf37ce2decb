(** Weak steps, [tau*] and [tau* a tau*], by a new search each time: no results are stored. *)

type t

val make : Effort.t -> Graph.t -> Graph.backwards -> t
(** [make effort g back] is working memory for searches in [g], one at a time. [back] is the reversed edges of [g].
*)

val weak_steps : t -> int -> (int -> int -> unit) -> unit
(** [weak_steps c s f] calls [f label target] once for each weak step of state [s]. Label 0 leads to each state
    that [tau*] reaches, [s] included. Any other label a leads to each state that [tau* a tau*] reaches. Raises
    {!Effort.Exhausted}. *)

val weak_sources : t -> int list -> (int -> unit) -> unit
(** [weak_sources c states f] calls [f] once for each state that has a weak step to a state of the list. Raises
    {!Effort.Exhausted}. *)
