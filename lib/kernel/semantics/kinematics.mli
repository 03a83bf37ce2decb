(** How bodies move, meet and respond: what the two calculi of the rule book differ in, and the signature that all
    other rules are written over. {!Straight} is motion in translation, {!Turning} that of bodies that turn. *)

open Scc_exact
open Scc_geometry
open Scc_calculus

(** Who may be near whom: where the rules quantify over all pairs of parts, whoever runs them may leave out those
    that cannot matter. {!everyone} leaves out none. *)
type neighbours = {
  within : Rat.t -> Part.t array -> (Part.t * Part.t) list;
  (** [within margin parts]: all pairs of parts of two processes that are at most [margin] apart now, and perhaps
      others; sorted by their places in the array, the lesser of a pair first *)
  earliest :
    margin:Rat.t -> limit:Rat.t option ->
    (before:Rat.t option -> Part.t -> Part.t -> Rat.t option) -> Part.t array -> Rat.t option;
  (** the least of the times that a function has for pairs of parts in relative motion, if it is at most the limit.
      For two parts that are farther apart than the margin up to a time, the function has none up to that time;
      what it has later than [before] does not count *)
}

val everyone : neighbours

(** What a law of a leaf chooses from: velocities with their chances, or why it cannot. *)
type shares = ((Vec.t * Rat.t) list, Law.fault) result

(** [laws leaf law ask] is [ask ()], for the law of a leaf: whoever runs the rules may remember it of one that
    gives the same wherever and whenever it is asked ({!Law.is_constant}). {!ask_again} does not. *)
type laws = int -> Law.t -> (unit -> shares) -> shares

val ask_again : laws

(** What the rules are applied in: all that does not change, and those who answer for it. *)
type setting = { model : Model.t; geometry : Geometry.t; neighbours : neighbours; laws : laws }

(** How two parts of different processes stand to each other. *)
type contact =
  | Apart
  | Touching  (** they touch and do not approach; or they are so near that {!S.bounce} has to see *)
  | Colliding  (** they touch and approach (rule Collision) *)

(** Two processes that meet, the one with the lesser index first. *)
type meeting = {
  first : int;
  second : int;  (** indices of processes *)
  collide : bool;  (** some parts of theirs touch and approach *)
  touching : (Part.t * Part.t) list;  (** all pairs of their parts that are not {!Apart} *)
}

module type S = sig
  (** {1 Contact} *)

  val parts : setting -> int -> State.process -> Part.t list
  (** The parts of a process, the one with this index, in the order of its leaves. *)

  val margin : setting -> Rat.t
  (** How far apart two parts may be that touch. *)

  val contact : setting -> Part.t -> Part.t -> contact

  val touching : setting -> Part.t -> Part.t -> Contact.pair list
  (** The features in which two parts touch; none if they are {!Apart}, or only seen as {!Touching}. *)

  val near : setting -> Part.t -> Part.t -> Scc_rigid.Near_contact.t option
  (** The contact of two parts, if they touch. *)

  val bonded : setting -> Part.t * Feature.t -> Part.t * Feature.t -> bool
  (** Whether two features, each of a part, may hold a bond (Definition 5.2). *)

  val first_time_of_contact : setting -> Part.t array -> limit:Rat.t option -> Rat.t option
  (** The least time at which two parts collide, if there is one that is at most the limit (rules Ftoc, Cast); of
      parts that do not collide now. Without a limit nothing may be spinning. *)

  val none_ahead : setting -> Part.t array -> bool
  (** Whether it is proved that no two parts ever collide, if nothing else happens to them (rule Quiescent). *)

  (** {1 What happens to processes} *)

  val bounce : setting -> State.process array -> meeting list -> State.process array option
  (** Rule Bounce: what becomes of some processes that collide in these meetings, all at once. [None]: they would
      interpenetrate at once, and nothing changes that (rule Persistent). *)

  val joined : setting -> State.process -> State.process -> State.process -> State.process
  (** [joined c p q whole]: the whole, made of p and q, in the motion that it gets from theirs (rule Bind). *)

  val piece : setting -> whole:State.process -> State.process -> State.process
  (** A piece of a whole, in the motion that the whole had (readings I-11 and I-23). *)

  val pushed : setting -> at:Vec.t -> Vec.t -> State.process -> State.process
  (** [pushed c ~at impulse p]: what an impulse at a place makes of the motion of a process; nothing, if it is
      fixed (reading I-36). *)

  val start : setting -> State.process -> State.process
  (** A declared process as it is at first. *)

  (** {1 Turns} *)

  val time_rules : Rule.t list
  (** Those that a passing of time uses. *)

  val renewed : setting -> State.process -> State.process
  (** The process with its turn ended. *)

  val at_contact : setting -> colliding:(State.t -> (int * int) list) -> State.t -> State.t
  (** The turns of all that collides end (rule Turn). [colliding] tells which two processes collide in a state. *)


  val begin_turns :
    setting ->
    parts:(State.t -> Part.t array) ->
    colliding:(State.t -> (int * int) list) ->
    State.t -> State.t * State.t option
  (** A turn begins of each process that a turn is due of and that does not collide (rules Turn and Round);
      with the state before that, if rule Round changed anything. [parts] tells the parts of a state.
      Nothing collides then that does not before. *)

  val turns_rightly : setting -> State.process -> bool
  (** Whether a process turns as it can: not at all, in a turn that has begun, or soon. *)

  val settled : setting -> State.process -> bool
  (** Whether no rounding is going to change where a process goes. *)
end
