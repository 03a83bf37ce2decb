(** Transitions of a network as data: label, rules, target. *)

open Scc_exact
open Scc_calculus

(** Two parts that touch, of different processes: each as its leaf and its index in it, the lesser one first. *)
type hit = { one : int * int; two : int * int }

(** A bond that a split releases, and the impulse by which the two leaves that it joined part (reading I-36). *)
type release = { bond : State.bond; push : Rat.t }

(** What may be decided of a bond at a split instant (rule Lot): by chance, but for the last. *)
type decision =
  | Kept  (** it stays *)
  | Let_go  (** it is to be released *)
  | First  (** it is to be released before others that end at one of its leaves *)
  | Chosen  (** in which of several ways it is to be released, which is a free choice *)

type label =
  | Time of Rat.t
  | Bind of State.bond  (** the bond that was made *)
  | Close of State.bond  (** the bond that was made, within one process *)
  | Bounce of { firsts : int list; hits : hit list }
  (** the first leaves of the processes, two or more, in order; and where they touch, in order *)
  | Absorb of { first : int; absorber : int }
  (** the first leaf of the process that is gone, and the leaf that took it *)
  | Weak_split of release list
  (** sorted by their bonds; several only where they are left to chance (rule Lot): all of an instant at once *)
  | Strong_split of release list  (** sorted by their bonds *)
  | Draw of { first : int; velocity : Vec.t; chance : Rat.t }
  (** the first leaf of the process, the velocity that it draws, and the probability of it: more than 0 *)
  | Lot of { bond : State.bond; decision : decision; chance : Rat.t }
  (** with the probability of the decision: more than 0; of what is chosen 1 *)

(** What happens to some processes, whatever the others do. *)
type outcome = {
  rule : Rule.t;  (** of the network *)
  label : label;
  fired : Behaviours.derivation list list;
  (** the summands that took part, in each way to do it; none in a bounce *)
  gone : State.process list;  (** who takes part *)
  come : State.process list;  (** what becomes of them, in order of first leaves *)
}

val distinct : outcome list -> outcome list
(** One of each label and result: what two summands do alike is one transition, in two ways. *)

val rules : outcome -> Rule.t list
(** Which rules made it, the network's rule first; in the first of the ways. *)

(** A transition of a network. *)
type t = {
  label : label;
  rules : Rule.t list;  (** which rules made it, the network's rule first *)
  fired : Behaviours.derivation list list;  (** the summands that took part, in each way to do it *)
  target : State.t;
  rounded : State.t option;
  (** if rule Round was used: the processes as they were before it, and nothing else of the target *)
}

(** Why a state's transitions cannot be computed. *)
type fault =
  | Bad_chance of State.finish  (** the chances that a leaf has for a bond sum to more than 1 *)
  | Bad_law of { leaf : int; fault : Law.fault }
  | Persistent_contact of int list
  (** processes, by their first leaves, would interpenetrate at once, and their response is zero (rule Persistent):
      time cannot pass *)

val duration : t -> Rat.t
(** 0 for a discrete transition. *)

val duration_of : label -> Rat.t

val bonds : label -> State.bond list
(** That are made or released; not those that lots are drawn for. *)

val is_time : label -> bool
(** The others are events. *)

val is_urgent : label -> bool
(** Whether no time passes while it is possible (rule Time): strong splits, closings, collisions, draws and lots.
*)

val chance : label -> Rat.t
(** The probability of what is drawn, among those of its state, which sum to 1; 1 of everything else. *)

val is_drawn : label -> bool
(** What chance decides: a velocity or a lot (rules Draw and Lot). While something is to be drawn, that is all
    that may happen. *)

val hit : int * int -> int * int -> hit
val compare_hit : hit -> hit -> int
val equal_label : label -> label -> bool

val renamed : (int -> int) -> label -> label
(** With other indices for the leaves, in a [Bounce] and an [Absorb] also for those that processes are told by,
    which need not be the first ones of these then. *)

val decision_to_string : decision -> string
(** [keep], [release], [first] or [choose]. *)

val time_of_string : string -> Rat.t option
(** Of a label [Time], as {!label_to_string} writes it. *)

val bond_to_string : Model.t -> State.bond -> string
(** [a, p.right, q.left]. *)

val label_to_string : Model.t -> label -> string
(** [time(1/2)], [bind(a, p.right, q.left)], [close(a, p.right, q.left)], [bounce(p, q)], [absorb(p, drain)],
    [weak(a, p.right, q.left)], of several [weak({<a, {p.right, q.left}>, …})],
    [strong({<a, {p.right, q.left}>, …})], [draw(p, (1, 0, 0)) chance(1/2)],
    [release(a, p.right, q.left) chance(1/2)], likewise [keep] and [first], and
    [choose(a, p.right, q.left)]. *)

val diagnostic : Model.t -> fault -> Scc_base.Diag.t
(** SC0601, SC0602 or SC0603. *)
