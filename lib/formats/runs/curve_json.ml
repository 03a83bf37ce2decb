open Scc_exact
open Scc_ctl
open Scc_evaluate
open Scc_json
open Json_format

(* {1 Pieces} *)

type piece = Number of Rat.t list * Rat.t list | None_as of string
type t = Whole of piece | Pieces of (Rat.t * piece) list

let format =
  let coefficients = list Shared.rational in
  let ratio = all [ field "n" coefficients fst; field "d" coefficients snd ] in
  let no_number = all [ field "none" some_text Fun.id ] in
  let number = function Number (n, d) -> Some (n, d) | None_as _ -> None in
  let none = function None_as why -> Some why | Number _ -> None in
  let whole f = function Whole p -> f p | Pieces _ -> None in
  let later f (from, p) = Option.map (fun x -> (from, x)) (f p) in
  let from () = field "from" Shared.rational fst in
  let piece =
    union
      [
        case (fields [ from (); within snd ratio ]) (later number) ignore;
        case (fields [ from (); within snd no_number ]) (later none) ignore;
      ]
  in
  let described text members = about text (obj members) in
  union
    [
      case
        (described "n(t) / d(t), coefficients from the constant one up, of the time t since the state." ratio)
        (whole number) ignore;
      case (described "There is no number, and why." no_number) (whole none) ignore;
      case
        (described
           "Several, each from a time since the state on; where that is irrational, from a rational within 10^-12 \
            before it. A single instant that differs from what comes right after it has a piece of its own, and \
            the next one begins where it does."
           (field "pieces" (list piece) Fun.id))
        (function Pieces all -> Some all | Whole _ -> None)
        ignore;
    ]
  |> named ~file:"view" "piece"

let value : Value.t -> piece = function
  | Ratio (n, d) -> Number (Polynomial.coefficients n, Polynomial.coefficients d)
  | Undefined why -> None_as why

let holds : Truth.t -> piece = function
  | True -> Number ([ Rat.one ], [ Rat.one ])
  | False -> Number ([ Rat.zero ], [ Rat.one ])
  | Undecided why -> None_as why

(* {1 Where they begin} *)

let width = Rat.make Z.one (Z.pow (Z.of_int 10) 12)

let instant a =
  match Algebraic.to_rat a with
  | Some r -> r
  | None -> fst (Algebraic.enclose a ~width)

let told equal piece line =
  let line = Timeline.simplify equal line in
  let stretch from at after =
    if equal at after then [ (from, after) ] else [ (from, at); (from, after) ]
  in
  let later (c : _ Timeline.piece) = stretch (instant c.cut) c.at c.after in
  let from (a, v) = (a, piece v) in
  match line.extent with
  | Instant -> Whole (piece line.start)
  | Lasts _ | Forever -> (
      match stretch Rat.zero line.start line.first @ List.concat_map later line.rest with
      | [ (_, v) ] -> Whole (piece v)
      | pieces -> Pieces (List.map from pieces))

let number line = told Value.equal value line
let truth line = told Truth.equal holds line
