(** The optimality equations of the open states: those whose values the graph alone does not decide. Some end
    components are merged into one unknown each.

    The unknowns are the nodes 0 .. size - 1. For each, x = opt over its rows r of constant(r) + sum p(e) x(node of
    e) over the entries e of r, where opt is min or max. The solution is unique, since no end component is left in
    which the sum of rewards would be 0:

    - For probabilities and greatest rewards no end component is left at all. So every scheduler leaves the open
      states almost surely.
    - For least rewards each cycle in an end component that is left has a positive reward. So a scheduler that
      stays in one pays without end, and some scheduler leaves (Bertsekas and Tsitsiklis, "An Analysis of
      Stochastic Shortest Path Problems", 1991).

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
  first_row : Int_array.t;  (** for each node, then the number of rows; a node has one row or more *)
  first_entry : Int_array.t;
  (** for each row, then the number of entries; the arrays of rows and entries may be longer than needed *)
  constant : Rat.t array;  (** for each row, at least 0 *)
  near_constant : float array;  (** the floats nearest to [constant] *)
  node : Int_array.t;  (** for each entry; never the node that has the row, and each node at most once in a row *)
  near : float array;  (** for each entry: the float nearest to its {!probability}, but never 0 *)
  mdp : Mdp.t;
  branch : Int_array.t;
  (** for each entry: the branch that has its probability; or -1 - i, where i is its index in [worked_out] *)
  worked_out : Rat.t array;  (** probabilities that are not those of a branch *)
  leaks : Bits.t;
  (** The rows in which the probabilities of entries within the component of the row have a sum less than 1. *)
  choice : Int_array.t;  (** for each row: the choice of the MDP that it stands for *)
  node_of : Int_array.t;  (** for each state; -1 if it is not open, or not needed *)
}

val first_row : t -> int -> int
(** [first_row e v] is the first row of node [v]; its rows end before [first_row e (v + 1)]. *)

val first_entry : t -> int -> int
(** [first_entry e r] is the first entry of row [r]; its entries end before [first_entry e (r + 1)]. *)

val node : t -> int -> int
(** [node e i] is the node that entry [i] leads to. *)

val choice : t -> int -> int
(** [choice e r] is the choice of the MDP that row [r] stands for, numbered through. *)

val node_of : t -> int -> int
(** [node_of e s] is the node of state [s]; -1 if the state is not open, or not needed. *)

val probability : t -> int -> Rat.t
(** [probability e i] is the exact probability of entry [i]: positive. *)

(** The status of a state before the equations are solved. *)
type status =
  | Known of Rat.t  (** its value is this *)
  | Open  (** its value is to be computed *)
  | Elsewhere  (** its value is known but no number (infinite); no allowed choice of an open state leads to it *)

val make :
  Backwards.t ->
  direction ->
  status:(int -> status) ->
  allowed:(int -> bool) ->
  merged:Components.ends ->
  rewards:bool ->
  asked:(int -> bool) option ->
  t
(** [make b direction ~status ~allowed ~merged ~rewards ~asked] is the equations of the open states that [allowed]
    choices reach from those that pass [asked]; for [None], of all open states. With [rewards] the constants
    contain the rewards of choices.

    The states of a component of [merged], all of them open, become one node, and its internal choices disappear. A
    row that leads to its own node with probability p < 1 is divided by 1 - p. A row with p = 1 is left out. That
    is right for least rewards only: for the others it would be an end component, which has to be merged. A node
    without any row is a bug. *)

val row_sum : t -> (int -> Rat.t) -> int -> Rat.t
(** [row_sum e value r] is the right side of row [r] for the values [value] of nodes. *)
