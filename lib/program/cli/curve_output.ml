open Scc_base
open Scc_exact
open Scc_property
open Scc_loading
open Scc_verify
open Scc_explain
open Scc_svg

let end_of (check : Property.check) =
  match (check.asked, check.formula) with
  | How_likely _, (Finally (_, bound, _) | Globally (_, bound, _) | Until (_, bound, _, _)) -> bound.high
  | _ -> None

let of_sets =
  Error
    [
      Diag.error Code.not_yet Span.command_line
        "--curve: this model is explored by sets of states, as it leaves values or instants open, and a curve is \
         that of one start"
        ~hint:"leave out --curve; or give all parameters values with `-D NAME=VALUE`, and a `split_step`";
    ]

let refused (l : Loaded.t) ~declared ~drawn name =
  let refuse option message = Error [ Diag.error Code.bad_value Span.command_line "%s: %s" option message ] in
  let fail = refuse "--curve" in
  match name with
  | None when drawn -> refuse "--curve-plot" "of which check? Give `--curve NAME` as well"
  | None -> Ok ()
  | Some name -> (
      let is_named (c : Property.check) = String.equal c.name name in
      match List.find_opt is_named l.checks with
      | None when List.exists is_named declared ->
        fail (Printf.sprintf "`%s' is not among the checks of --check: add `--check %s'" name name)
      | None -> Error [ Input.no_check Code.unknown_name Span.command_line name l.checks ]
      | Some check when Option.is_none (end_of check) ->
        fail
          (Printf.sprintf
             "`%s' does not ask for a probability within a time, as `P = ? [ eventually f within t ]' does" name)
      | Some _ when Scc_verdicts.Verdicts.over_zones l -> of_sets
      | Some _ -> Ok ())

let lines (v : Verdict.t) =
  let line (p : Verdict.point) =
    let time = Algebraic.to_string p.moment.offset in
    let from = if p.moment.attained then "from" else "after" in
    Printf.sprintf "    %s %s: %s\n" from time (Likelihoods.values p.answer)
  in
  match v with
  | Measured { curve = _ :: _ as curve; _ } -> "  within T, for T\n" ^ String.concat "" (List.map line curve)
  | Measured _ | Depends _ | Holds _ | Violated _ | Undecided _ -> ""

(* {1 As a picture} *)

let near = Rat.make Z.one (Z.of_int 1_000_000)

let ends (m : Scc_ctl.Eval.measured) =
  let low = Option.value (Scc_chance.Answer.lower m.least) ~default:Rat.zero in
  (low, Option.value (Scc_chance.Answer.upper m.most) ~default:Rat.one)

(* Each value is a level line up to the next time. *)
let steps last rows : Chart.point list =
  let point x m : Chart.point =
    let low, high = ends m in
    { x; y = Rat.middle low high; band = Some (low, high) }
  in
  let rec go done_ = function
    | (x, m) :: ((y, _) :: _ as rest) -> go (point y m :: point x m :: done_) rest
    | [ (x, m) ] -> List.rev (point last m :: point x m :: done_)
    | [] -> List.rev done_
  in
  go [] rows

let panel (o : Verdict.outcome) : Chart.panel option =
  match (o.verdict, end_of o.check) with
  | Measured { curve = first :: _ as curve; _ }, Some last ->
    let column k (side, _) : Chart.curve =
      let row (p : Verdict.point) =
        (fst (Algebraic.enclose p.moment.offset ~width:near), snd (List.nth p.answer k))
      in
      let name = match (side : Property.side) with Least -> "least" | Greatest -> "greatest" in
      { name; pieces = [ steps last (List.map row curve) ] }
    in
    let same (p : Verdict.point) =
      match p.answer with (_, a) :: rest -> List.for_all (fun (_, b) -> Likelihoods.equal a b) rest | [] -> true
    in
    let curves = List.mapi column first.answer in
    let curves = if List.for_all same curve then List.filteri (fun k _ -> k = 0) curves else curves in
    Some { title = o.check.name; curves }
  | _ -> None

let picture ~title outcomes =
  let caption = "the probability within each time" in
  Chart.sheet ~title ~caption ~x:"time" ~named:[] (List.filter_map panel outcomes) []
