(** The first difference of two recorded traces, in terms of the calculus. No model is needed. Parts that only
    one of the traces records are not compared, except events, which both record completely. *)

open Scc_exact

(** One of the two traces. *)
type side = First | Second

(** A difference. *)
type t =
  | Header of { what : string; first : string; second : string }
  (** ["digest"], or a parameter: the two are not of one model *)
  | Event of {
      number : int;  (** from 1 *)
      first : Recorded.item;
      second : Recorded.item;
      what : event_difference;
    }
  | More of { side : side; number : int; item : Recorded.item }  (** an event that only one has *)
  | State of {
      first : Recorded.item;
      second : Recorded.item;
      events : int;  (** so many events came before *)
      body : string;
      quantity : string;
      (** of the body; ["time"] of the record; ["name"], if each records a body that the other does not *)
      told : string * string;
      off : Rat.t option;  (** the second less the first *)
    }
  | Ending of {
      first : Recorded.item;
      second : Recorded.item;
      quantity : string;  (** ["time"] or ["claim"] *)
      told : string * string;
      off : Rat.t option;
    }

(** How two events differ. *)
and event_difference =
  | Label  (** something else happens *)
  | Time of Rat.t  (** the same later, in the second, by so much *)
  | Choice of int * int  (** the same, but it was another choice *)
  | Rules of string list * string list

val find : Recorded.t -> Recorded.t -> tolerance:Rat.t -> t option
(** The first difference of two traces. Numbers that differ by at most the tolerance are equal. *)
