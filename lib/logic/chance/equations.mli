(** What is left of a question once the graph has answered what it can: the optimality equations of the states that
    are open, with end components of which nothing leaks made into one unknown each.

    The unknowns are the nodes 0 .. size - 1. For each, x = opt over its rows r of constant(r) + sum p(e) x(node of
    e) over the entries e of r, where opt is min or max. What makes the values of the question the only solution,
    is that no end component is left in which the sum of rewards would be 0:

    - probabilities, and greatest rewards: none at all, so that every scheduler leaves the open states almost
      surely;
    - least rewards: each that is left costs something each time round, so that a scheduler that stays in one pays
      without end, and some scheduler leaves (Bertsekas and Tsitsiklis, "An Analysis of Stochastic Shortest Path
      Problems", 1991).

    Collapsing end components: Haddad and Monmege, "Interval Iteration Algorithm for MDPs and IMDPs", 2018; Brázdil
    et al., "Verification of Markov Decision Processes Using Learning Algorithms", 2014; Baier et al., "Ensuring
    the Reliability of Your Model Checker", 2017. *)

open Scc_exact
open Scc_data

type direction = Min | Max

type t = private {
  direction : direction;
  size : int;
  parts : int array;
  (** The nodes of component k of the graph of nodes are parts.(k) .. parts.(k + 1) - 1; no entry leads to a
      greater component. *)
  first_row : Int_array.t;  (** of each node, and the number of rows; a node has one row or more *)
  first_entry : Int_array.t;
  (** of each row, and the number of entries; the arrays of rows and entries may be longer than that *)
  constant : Rat.t array;  (** of each row, at least 0 *)
  near_constant : float array;  (** the nearest floats *)
  node : Int_array.t;  (** of each entry; never the node that has the row, and each node once in a row *)
  near : float array;  (** of each entry: the float nearest to its {!probability}, but never 0 *)
  mdp : Mdp.t;
  branch : Int_array.t;
  (** of each entry: the branch that has its probability; or -1 - its place in [worked_out] *)
  worked_out : Rat.t array;  (** probabilities that are not those of a branch *)
  leaks : Bits.t;
  (** The rows of which the entries of its own component have a sum less than 1. *)
  choice : Int_array.t;  (** of each row: the choice of the MDP that it stands for *)
  node_of : Int_array.t;  (** of each state; -1: it is not open, or was not asked for *)
}

val first_row : t -> int -> int
val first_entry : t -> int -> int
val node : t -> int -> int
val choice : t -> int -> int
val node_of : t -> int -> int

val probability : t -> int -> Rat.t
(** Of an entry: positive. *)

(** What is known of a state beforehand. *)
type status =
  | Known of Rat.t
  | Open
  | Elsewhere  (** of another value that is known (infinite); no allowed choice of an open state leads to it *)

val make :
  Backwards.t ->
  direction ->
  status:(int -> status) ->
  allowed:(int -> bool) ->
  merged:Components.ends ->
  rewards:bool ->
  asked:(int -> bool) option ->
  t
(** Of the open states that can be reached from those asked for by allowed choices, or of all. The states of a
    component of [merged], all of them open, become one node, and its internal choices disappear. A row that
    leads to its own node with probability p < 1 is divided by 1 - p; with p = 1, it is left out, which is right
    for least rewards alone, and only if something is left: elsewhere it is an end component, which should have
    been merged. *)

val row_sum : t -> (int -> Rat.t) -> int -> Rat.t
(** The right side of a row, for the values of the nodes that its entries lead to. *)
