(** Bonds at birth (Definition 5.2): those written within processes and those that join processes declared
    apart. *)

open Scc_base
open Scc_calculus

(** Leaves are numbers in the order of declaration. *)
type t = {
  name : string;
  one : int * Site.t;
  two : int * Site.t;
  span : Span.t;
}

val read : Context.t -> Program.t -> Bodies.t -> Composition.t -> t list
(** The bonds of the network. Each pair of features touches (SC0401; it need not be the highest pair), the
    bonds close no cycle (SC0406), and what they join moves as one (SC0404). No bond joins a process of the
    network to one that is left out (SC0210). *)
