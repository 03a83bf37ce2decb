(** The reversed branches of an MDP: which choices lead to a state. Each table is made when it is first used, since
    many questions need none of them, and serves all later questions. *)

type t

val make : Mdp.t -> t
(** [make m] is the reversed branches of [m], not computed yet. *)

val mdp : t -> Mdp.t
(** [mdp b] is the MDP given to {!make}. *)

val owner : t -> int -> int
(** [owner b c] is the state that has choice [c]. *)

val iter : t -> int -> (int -> unit) -> unit
(** [iter b s f] calls [f] once for each choice that has a branch to state [s]. *)

val with_mdp : t -> Mdp.t -> t
(** [with_mdp b m] is the reversed branches of [m], which has the graph of {!mdp}: the tables are shared. *)
