(** What matters in a state, for people who look at a graph: what differs between its states, but for where
    things are. *)

open Scc_calculus

type t

val make : positions:bool -> Model.t -> size:int -> (int -> State.t) -> t
(** Of so many states. With [positions], also where things that are not fixed are, and how they move. *)

val lines : t -> int -> string list
(** Of a state: the bonds that not every state has, then the behaviours that are not everywhere the same. A
    behaviour that has aged since it became K is [K*]; long ones are cut. *)
