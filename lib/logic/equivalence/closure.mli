(** Weak steps, searched for anew each time: [tau*] and [tau* a tau*]. *)

type t

val make : Effort.t -> Graph.t -> Graph.backwards -> t
(** Room for a search in the graph; one search at a time. *)

val weak_steps : t -> int -> (int -> int -> unit) -> unit
(** [weak_steps c s f] is [f label target] for each weak step of [s]: [label] 0 with what [tau*] reaches, [s]
    among them; any other label a with what [tau* a tau*] reaches. Each pair once. *)

val weak_sources : t -> int list -> (int -> unit) -> unit
(** Each state that has a weak step to one of the list, once. *)
