(** Steps of walkers that wait where they are blocked (rule Blocked), from the draws of one instant to those of the
    next (rule JoinedDraws). What two processes are to each other in a step is found once for each two, in a
    cache. *)

open Scc_exact
open Scc_geometry
open Scc_semantics

type t

val make : units:Course_units.t list -> most:int -> Local.t -> t option
(** [make ~units ~most local] has empty caches, which grow to [most] processes, a power of two, and to 16 times as
    many pairs. [units] are what formulas see of the way. The result is [None] for models to which nothing here
    applies: walkers bounce or stop, bodies turn, bind at rest or split by lot, or steps are not those of all. *)

val catalogue : t -> Catalogue.t
(** The numbers of all components. *)

val leaves : t -> int
(** The number of leaves of the model. *)

val timestep : t -> Rat.t
(** The duration of a step. *)

(** {1 Processes} *)

(** A process on its course through one step. *)
type course = private {
  number : int;  (** its number when the step begins *)
  calm : bool;
  (** by itself it does nothing but move, and it rests or is a walker that draws in the end, whatever its
      velocity and the time are then; if not, the other fields count for nothing *)
  walks : bool;  (** it is a walker *)
  rests : bool;  (** its velocity is zero *)
  box : Float_box.t;  (** about its sweep *)
  ended : int;  (** its number at rest where it is in the end, as if it were there from the beginning *)
  next : int;  (** its number in the end, while it waits to draw again *)
  unseen : bool;  (** no unit that is about it alone tells [ended] from it *)
}

val course : t -> int -> course
(** The course of the process with this number. *)

(** A process that waits to draw. *)
type walker = private {
  waiting : int;  (** its number *)
  kicks : (int * Vec.t * Rat.t) array;
  (** what it may draw: its number when the step begins, its velocity, and the chance *)
  stays : int;  (** its number when the step begins and its kick is blocked *)
  able : bool;  (** its courses are calm, and its law has a value; if not, the other fields count for nothing *)
}

val walker : t -> int -> walker
(** The process with this number, which waits to draw. *)

val together : t -> course -> course -> Blocked.together
(** [together w a b] is {!Blocked.together} of two processes. *)

(** {1 States} *)

val standing : t -> int array -> int array
(** [standing w tuple] is the state that stands for [tuple]. In a state in which a step begins, nothing may happen
    before all walkers draw again. Then each walker that no unit sees on its way is at rest where it will be in the
    end. Any other state stands for itself. *)

val pass : t -> int array -> (int * int array) option
(** [pass w tuple] is the passing of time through a step that begins in [tuple], as the number of its label and its
    target, whose walkers have lost their velocities. It is the only transition. The result is [None] if something
    may happen before all walkers draw again, or if fewer than two of them do. *)
