(** Transitions of a network as data: label, rules, target. *)

open Scc_exact
open Scc_calculus

(** Two parts of different processes that touch, the lesser one first. Each is the index of its leaf and its
    index in the leaf. *)
type hit = { one : int * int; two : int * int }

(** A bond that a split releases, and the impulse that drives its two leaves apart (reading I-36). *)
type release = { bond : State.bond; push : Rat.t }

(** What may be decided of a bond at a split instant (rule Lot). The first three are decided by chance, [Chosen]
    is a free choice. *)
type decision =
  | Kept  (** it stays *)
  | Let_go  (** it is to be released *)
  | First  (** it is to be released before others that end at one of its leaves *)
  | Chosen  (** the way to release it is chosen from several *)

type label =
  | Time of Rat.t
  | Bind of State.bond  (** the bond that was made *)
  | Close of State.bond  (** the bond that was made, within one process *)
  | Bounce of { firsts : int list; hits : hit list }
  (** the first leaves of the processes, two or more, in order; and the parts that touch, in order *)
  | Absorb of { first : int; absorber : int }
  (** the first leaf of the process that is absorbed, and the leaf that absorbs it *)
  | Weak_split of release list
  (** sorted by their bonds; several only where splits are left to chance (rule Lot): all releases of an instant at
      once *)
  | Strong_split of release list  (** sorted by their bonds *)
  | Draw of { first : int; given : Given.t; chance : Rat.t }
  (** the first leaf of the process, the motion that it draws, and the probability of that motion, more than 0 *)
  | Lot of { bond : State.bond; decision : decision; chance : Rat.t }
  (** [chance] is the probability of the decision, more than 0; 1 for [Chosen] *)

(** What happens to some processes, whatever the others do. *)
type outcome = {
  rule : Rule.t;  (** the rule of the network *)
  label : label;
  fired : Behaviours.derivation list list;
  (** the summands that took part, in each way to do it; none in a bounce *)
  gone : State.process list;  (** the processes that take part *)
  come : State.process list;  (** what becomes of them, in order of first leaves *)
}

val distinct : outcome list -> outcome list
(** The outcomes without repetition of label and result. Two summands with the same outcome give one outcome, which
    has both of them in [fired]. *)

val rules : outcome -> Rule.t list
(** The rules that made an outcome, in the first of its ways: the network's rule, then those of the behaviours. *)

(** A transition of a network. *)
type t = {
  label : label;
  rules : Rule.t list;  (** the rules that made it, the network's rule first *)
  fired : Behaviours.derivation list list;  (** the summands that took part, in each way to do it *)
  target : State.t;
  chance : Rat.t option;
  (** its probability, if chance decides: it is drawn ({!is_drawn}), or it is one of several urgent transitions in
      a model that draws which comes first (rule Ties) *)
  rounded : State.t option;
  (** if rule Round was used: the processes as they were before it, and nothing else of the target *)
}

(** Why a state's transitions cannot be computed. *)
type fault =
  | Bad_chance of State.finish  (** the chances that this end has to release its bond sum to more than 1 *)
  | Bad_law of { leaf : int; fault : Law.fault }  (** the law of this leaf has no value here *)
  | Persistent_contact of int list
  (** processes, by their first leaves, would interpenetrate at once, and their response is zero (rule Persistent):
      time cannot pass *)

val duration : t -> Rat.t
(** The time that passes in a transition; 0 for a discrete one. *)

val duration_of : label -> Rat.t
(** The time that passes in a transition with this label; 0 for a discrete one. *)

val bonds : label -> State.bond list
(** The bonds that a transition makes or releases. Draws of lots make and release none. *)

val is_time : label -> bool
(** [is_time l] is true if [l] is a passing of time. All other labels are events. *)

val is_urgent : label -> bool
(** [is_urgent l] is true if no time passes while a transition with this label is possible (rule Time). Strong
    splits, closings, collisions, draws and lots are urgent. *)

val chance : label -> Rat.t
(** The probability of a draw or a lot; 1 for all other labels. The probabilities of all outcomes of one draw or
    lot sum to 1. *)

val is_drawn : label -> bool
(** [is_drawn l] is true if chance decides: [l] is a [Draw], or a [Lot] that is not [Chosen] (rules Draw and Lot).
    While something is to be drawn, nothing else may happen. *)

val hit : int * int -> int * int -> hit
(** [hit a b] is the pair of parts [a] and [b], given in any order. *)

val compare_hit : hit -> hit -> int
(** A total order on hits: by the lesser part, then by the greater one. *)

val equal_label : label -> label -> bool
(** [equal_label a b] is true if [a] and [b] are equal in all fields. *)

val renamed : (int -> int) -> label -> label
(** [renamed image l] is [l] with the index of each leaf replaced. The leaves that identify processes in a
    [Bounce], an [Absorb] or a [Draw] are replaced as well. Their images may not be the first leaves of their
    processes. *)

val decision_to_string : decision -> string
(** A decision as in labels: [keep], [release], [first] or [choose]. *)

val time_of_string : string -> Rat.t option
(** The duration of a label [Time], from the text that {!label_to_string} writes; [None] for text of another
    form. *)

val bond_to_string : Model.t -> State.bond -> string
(** A bond as text, without brackets: [a, p.right, q.left]. *)

val label_to_string : Model.t -> label -> string
(** A label as text:
    - [time(1/2)];
    - [bind(a, p.right, q.left)], [close(a, p.right, q.left)];
    - [bounce(p, q)], [absorb(p, drain)];
    - [weak(a, p.right, q.left)], for several bonds [weak({<a, {p.right, q.left}>, …})];
    - [strong({<a, {p.right, q.left}>, …})];
    - [draw(p, (1, 0, 0)) chance(1/2)];
    - [release(a, p.right, q.left) chance(1/2)], and [keep] and [first] in this form;
    - [choose(a, p.right, q.left)].

    A push that is not 0 follows its bond: [push(2)]. *)

val diagnostic : ?at:Rat.t array -> Model.t -> fault -> Scc_base.Diag.t
(** The message for a fault: SC0601 for a law, SC0602 for a persistent contact, SC0603 for chances. A law's message
    has the place of its declaration. [at] is the values of the parameters with ranges for which there is the
    fault: the message names them. *)
