(** The branches of an MDP the other way round: which choices lead to a state. Made once for all questions,
    and when it is first asked for: many need none of it. *)

type t

val make : Mdp.t -> t
val mdp : t -> Mdp.t

val owner : t -> int -> int
(** The state that has the choice. *)

val iter : t -> int -> (int -> unit) -> unit
(** [iter b s f] calls [f] for each choice that has a branch to [s], once. *)
