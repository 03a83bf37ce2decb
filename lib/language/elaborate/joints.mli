(** Bonds at birth (Definition 5.2): those within processes, and those between processes that are declared
    apart. *)

open Scc_calculus

(** A bond with its two ends. Leaves have their numbers in the order of declaration. *)
type t = {
  name : string;
  one : int * Site.t;
  two : int * Site.t;
}

val read : Context.t -> Program.t -> Bodies.t -> Composition.t -> t list
(** The bonds of the network. The features of each bond touch (SC0401); they need not be the highest pair.
    Bodies that are bound move as one (SC0404). No bond joins a process of the network to one that is left out
    (SC0210).

    Bonds close no cycle, unless the model says [bonds cyclic]; two bodies then still have at most one bond
    (SC0406). A body that absorbs has no bonds (SC0409). *)
