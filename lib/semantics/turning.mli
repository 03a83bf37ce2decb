(** The kinematics of the rigid calculus, in which bodies turn as they move (rules Turn, Cast, Near, Impact and
    Persistent). *)

open Scc_exact
open Scc_calculus

include Kinematics.S

val apart : Kinematics.setting -> State.t -> int -> by:Rat.t -> bool
(** Whether a process (by its index) is farther than a distance from every other one. *)
