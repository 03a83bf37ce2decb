(** Numbers and truth values over time, from a state on, as exact pieces: functions of the time since that
    state.

    A piece is an object with the coefficients of a numerator and a denominator, or with the reason why there is
    no number. If the function changes in between, there are several pieces, each with its beginning. A value at
    a single instant has a piece of its own, and the next piece begins at the same instant. An irrational
    instant is replaced by a rational at most 10^-12 before it. *)

open Scc_exact
open Scc_ctl
open Scc_evaluate
open Scc_json

(** A quotient of polynomials, by the coefficients from the constant one up, or why there is no number. *)
type piece = Number of Rat.t list * Rat.t list | None_as of string

(** One piece, or several, each with its beginning. *)
type t = Whole of piece | Pieces of (Rat.t * piece) list

val format : (t, unit) Json_format.t
(** The format of a function of time. *)

val number : Value.t Timeline.t -> t
(** A number over time. *)

val truth : Truth.t Timeline.t -> t
(** A truth value over time as the numbers 1 and 0, with the reason where it is undecided. *)
