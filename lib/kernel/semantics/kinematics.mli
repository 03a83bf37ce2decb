(** How bodies move, meet and respond: the signature that all other rules are written over. The two calculi of
    the rule book differ in its implementation. {!Straight} is motion in translation, {!Turning} is the motion of
    bodies that turn. *)

open Scc_exact
open Scc_geometry
open Scc_calculus

(** A filter of pairs of parts. Where the rules quantify over all pairs, the filter may leave out pairs that cannot
    matter. {!everyone} leaves out none. *)
type neighbours = {
  within : Rat.t -> Part.t array -> (Part.t * Part.t) list;
  (** [within margin parts] is all pairs of parts of two processes that are at most [margin] apart now, and perhaps
      others; sorted by their indices in the array, the lesser of a pair first *)
  along : Rat.t -> Part.t array -> (Part.t * Part.t) list;
  (** [along span parts] is all pairs of parts of two processes such that the spaces touch that they sweep in the
      next [span], and perhaps others; in the same order. The processes do not turn. *)
  earliest :
    margin:Rat.t -> limit:Rat.t option ->
    (before:Rat.t option -> Part.t -> Part.t -> Rat.t option) -> Part.t array -> Rat.t option;
  (** [earliest ~margin ~limit time parts] is the least [time] of all pairs of parts in relative motion, if it is
      at most [limit]. If two parts are farther apart than [margin] up to an instant, [time] must give none up to
      that instant. Any result of [time] that is later than [before] is ignored. *)
}

val everyone : neighbours
(** The filter that leaves out no pair: quadratic in the number of parts. *)

(** What the law of a leaf chooses from, with the probabilities, or why there is nothing. A spin is [None] where
    the law leaves it as it is. *)
type shares = ((Given.t * Rat.t) list, Law.fault) result

(** [laws leaf law eval] is [eval ()], the shares of the law of a leaf. An implementation may cache the result
    for a law that is constant ({!Scc_calculus.Law.is_constant}). *)
type laws = int -> Law.t -> (unit -> shares) -> shares

val ask_again : laws
(** The {!type-laws} without a cache: each call evaluates the law. *)

(** The unchanging context of the rules: the model, and the implementations of geometry, neighbours and laws. *)
type setting = { model : Model.t; geometry : Geometry.t; neighbours : neighbours; laws : laws }

(** How two parts of different processes stand to each other. *)
type contact =
  | Apart
  | Touching  (** they touch and do not approach; or they are so near that {!S.bounce} has to decide *)
  | Colliding  (** they touch and approach (rule Collision) *)

(** Two processes that meet, the one with the lesser index first. *)
type meeting = {
  first : int;
  second : int;  (** indices of processes *)
  collide : bool;  (** some of their parts touch and approach *)
  touching : (Part.t * Part.t) list;  (** all pairs of their parts that are not {!Apart} *)
}

module type S = sig
  (** {1 Contact} *)

  val parts : setting -> int -> State.process -> Part.t list
  (** [parts c i p] is the parts of process [p], which has index [i] in the state, in the order of its leaves. *)

  val margin : setting -> Rat.t
  (** An upper bound on the distance of two parts that touch: 0, or the resolution of a rigid model. *)

  val contact : setting -> Part.t -> Part.t -> contact
  (** How two parts of different processes stand to each other now. Interpenetration is a bug. In the rigid
      calculus the result is [Colliding] or [Touching], never [Apart]. *)

  val touching : setting -> Part.t -> Part.t -> Contact.pair list
  (** The features in which two parts touch. The list is empty if the parts are apart, even if {!val-contact} is
      {!Touching}. *)

  val near : setting -> Part.t -> Part.t -> Scc_rigid.Near_contact.t option
  (** The contact of two parts; [None] if they do not touch. *)

  val bonded : setting -> Part.t * Feature.t -> Part.t * Feature.t -> bool
  (** [bonded c (a, f) (b, g)] is true if a bond may join feature [f] of part [a] to feature [g] of part [b]
      (Definition 5.2). *)

  val first_time_of_contact : setting -> Part.t array -> limit:Rat.t option -> Rat.t option
  (** The least time from now at which two parts collide, if it is at most the limit (rules Ftoc, Cast); else
      [None]. The parts must not collide now. If something spins, a limit is needed: a bug without it. *)

  val none_ahead : setting -> Part.t array -> bool
  (** [none_ahead c parts] is true if it is proved that no two of [parts] ever collide on their present courses
      (rule Quiescent). *)

  (** {1 What happens to processes} *)

  val bounce : setting -> State.process array -> meeting list -> State.process array option
  (** Rule Bounce: some processes after they have collided in these meetings, all at once. The result is [None] if
      they would interpenetrate at once whatever their response (rule Persistent). *)

  val joined : setting -> State.process -> State.process -> State.process -> State.process
  (** [joined c p q whole] is [whole], made of p and q, in the motion that follows from theirs (rule Bind). *)

  val piece : setting -> whole:State.process -> State.process -> State.process
  (** [piece c ~whole p] is [p], a piece of [whole], in the motion that the whole had (readings I-11 and I-23). *)

  val pushed : setting -> at:Vec.t -> Vec.t -> State.process -> State.process
  (** [pushed c ~at impulse p] is [p] after an impulse at the world position [at] (reading I-36). The motion of a
      fixed process stays as it is. *)

  val start : setting -> State.process -> State.process
  (** [start c p] is a declared process as it is in the initial state. If it has turns, the first one is due. *)

  (** {1 Turns} *)

  val time_rules : Rule.t list
  (** The rules that a passing of time uses: Time and TimeBehaviour, and Turn where bodies turn. *)

  val renewed : setting -> State.process -> State.process
  (** [renewed c p] is [p] with its turn ended and, if it has turns at all, the next one due. *)

  val at_contact : setting -> colliding:(State.t -> (int * int) list) -> State.t -> State.t
  (** [at_contact c ~colliding s] is [s] with the turns of all colliding processes ended (rule Turn), again until
      nothing that turns on collides. [colliding] is the pairs of processes of a state that collide. *)

  val begin_turns :
    setting ->
    parts:(State.t -> Part.t array) ->
    colliding:(State.t -> (int * int) list) ->
    State.t -> State.t * State.t option
  (** [begin_turns c ~parts ~colliding s] is [s] after the due turns of all processes that do not collide have
      begun (rules Turn and Round). The second result is [s] itself, if rule Round changed anything. [parts] is
      the parts of a state. Only processes that collided before collide afterwards. *)

  val turns_rightly : setting -> State.process -> bool
  (** [turns_rightly c p] is true if the turn of [p] is consistent: none, one that has begun, or one that is due.
  *)

  val settled : setting -> State.process -> bool
  (** [settled c p] is true if no later rounding can change the course of [p]. *)
end
