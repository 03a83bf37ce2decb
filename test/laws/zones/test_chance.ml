(* Probabilities and means over all starts are those of the ordinary exploration, at each start: random models with
   one or two walkers, up to three parameters that delays and predicates may mention, walls, receptors, bonds
   that break by chance or at any time, and free choices. Each is asked at random starts, on borders of pieces too.
   Their means are those of grids, where all pieces are boxes with corners on the grid.

   test_chance [MODELS [SEED]]

   With FINE=16 in the environment models with bonds that break at any time are tried, and no others. Their values
   are those with as many instants in a unit of time, at starts that are multiples of 1/4: what changes with the
   instant changes at multiples of 1/8, so that the grid has an instant between them. *)

open Scc_exact
open Scc_polyhedra
open Scc_graph_search
open Scc_verify
open Scc_zones
module Loaded = Scc_loading.Loaded

let argument i default = if Array.length Sys.argv > i then int_of_string Sys.argv.(i) else default
let seed = argument 2 1
open Chance_models

(* {1 Both ways} *)

let fine = Option.map int_of_string (Sys.getenv_opt "FINE")

(* Bonds that may break at any time may do so at these instants. *)
let at_instants =
  let parts = Option.value fine ~default:2 in
  Str.global_replace (Str.regexp_string any_time) (Printf.sprintf "split_step 1/%d\n" parts)

let load ?(overrides = []) text =
  let read_file _ = Error "no file" in
  Loaded.load ~read_file ~overrides (Scc_base.Source.make ~name:"m.sc" text)

let options_of states =
  { Setup.default with bounds = { Bounds.default with states = Given states; depth = Given 60 } }
let options = options_of (if Option.is_some fine then 60_000 else 4_000)

(* Of two walkers with starts of their own, values have pieces by the hundred. *)
let over_zones ranges =
  if Option.is_some (Scc_calculus.Ranges.find ranges "other") then options_of 150 else options

(* Work that is given up after so many zones; of what is tried later, some is. *)
let given_up_after random zones (options : Setup.t) =
  let left = ref zones in
  let run (type a) (stage : Limits.stage) (f : unit -> a) : (a, Limits.stop) result =
    match stage with
    | Concluding | Reporting -> Ok (f ())
    | Exploring | Proving ->
      decr left;
      if !left = -1 || (!left < 0 && Random.State.bool random) then Error Seconds else Ok (f ())
  in
  let bounds = { options.bounds with seconds = Given 1. } in
  { options with bounds; surroundings = Limits.undivided ~attempt:{ run } () }

module Side = struct
  type t = Scc_property.Property.side = Least | Greatest
end

(* The ends of a number; None is infinite. *)
type ends = Rat.t option * Rat.t option
type answer = Values of (Side.t * ends) list | Truth of bool option | Nothing

let outcome (r : Check.report) = List.hd r.outcomes

(* What the ordinary exploration says of one start. *)
let single text overrides =
  match load ~overrides text with
  | Error _ -> Nothing
  | Ok l -> (
      match Loaded.initial l with
      | Error _ -> Nothing
      | Ok initial -> (
          match (outcome (Check.run options l.semantics ~initial l.checks)).verdict with
          | Holds { bounds = []; _ } -> Truth (Some true)
          | Violated _ -> Truth (Some false)
          | Measured { values; _ } ->
            let ends (side, (m : Scc_ctl.Eval.measured)) =
              (side, (Scc_chance.Answer.lower m.least, Scc_chance.Answer.upper m.most))
            in
            Values (List.map ends values)
          | Holds _ | Depends _ | Undecided _ -> Nothing))

let at point (side, (c : Scc_regions.Chances.t)) =
  let part = List.find (fun (p : Scc_regions.Chances.part) -> Union.mem p.set point) c.parts in
  let value = Option.map (fun f -> Linear.eval f point) in
  (side, (value part.value.least, value part.value.most))

let over_starts (report : Check.report) point =
  match (outcome report).verdict with
  | Measured { starts; _ } ->
    let is_known (_, (c : Scc_regions.Chances.t)) = not (Union.mem c.unknown point) in
    if List.for_all is_known starts then Values (List.map (at point) starts) else Truth None
  | Holds _ | Violated _ | Depends _ | Undecided _ ->
    let w = List.hd report.where in
    if Union.mem w.holds point then Truth (Some true)
    else if Union.mem w.fails point then Truth (Some false)
    else Truth None

let told = function
  | Values list ->
    let end_ = Option.fold ~none:"infinite" ~some:Rat.to_string in
    String.concat "; " (List.map (fun (_, (a, b)) -> end_ a ^ " .. " ^ end_ b) list)
  | Truth (Some b) -> string_of_bool b
  | Truth None -> "not known"
  | Nothing -> "nothing"

(* Each knows the value, or bounds of it: they must be of one value. Exact values of one start are those of all.
   If bonds break at any time there, and [one] has them break at some instants, the least value is at most that of
   [one], and the greatest at least. *)
let agree ~any one all =
  let at_most a b =
    match (a, b) with _, None -> true | None, Some _ -> false | Some a, Some b -> Rat.compare a b <= 0
  in
  match (one, all) with
  | Values one, Values all ->
    let same ((side : Side.t), (a, b)) (_, (c, d)) =
      (at_most a d || (any && side = Least)) && (at_most c b || (any && side = Greatest))
    in
    List.for_all2 same one all
  | Truth (Some a), Truth (Some b) -> if any then a || not b else Bool.equal a b
  | (Truth _ | Values _), Truth None | Truth None, Truth _ | Nothing, _ -> true
  | _ -> false

let exact = function
  | Values list -> List.for_all (fun (_, (a, b)) -> Option.equal Rat.equal a b) list
  | Truth b -> Option.is_some b
  | Nothing -> false

(* Starts: random ones, and one in each piece. *)
let points random (l : Loaded.t) (report : Check.report) =
  let ranges = l.model.ranges in
  let random_point () =
    let coordinate _ =
      Rat.make (Z.of_int (Random.State.int random 49 - 16)) (Z.of_int (pick random [ 1; 2; 4; 8; 16 ]))
    in
    Array.init (Array.length ranges) coordinate
  in
  let in_range point =
    let ok = ref true in
    Array.iteri (fun i x -> if not (Scc_calculus.Ranges.mem ranges.(i) x) then ok := false) point;
    !ok
  in
  let of_set u =
    List.concat_map
      (fun p -> List.filter_map Fun.id [ Polyhedron.interior_point p; Polyhedron.corner p ])
      (Union.pieces u)
  in
  let sets =
    match (outcome report).verdict with
    | Measured { starts; _ } ->
      let set (p : Scc_regions.Chances.part) = p.set in
      List.concat_map (fun (_, (c : Scc_regions.Chances.t)) -> c.unknown :: List.map set c.parts) starts
    | Holds _ | Violated _ | Depends _ | Undecided _ ->
      let w = List.hd report.where in
      [ w.holds; w.fails ]
  in
  let is_coarse (x : Rat.t) = Z.divisible (Z.of_int 4) x.den in
  let coarse point = Option.is_none fine || Array.for_all is_coarse point in
  List.filter
    (fun p -> in_range p && coarse p)
    (List.init 12 (fun _ -> random_point ()) @ List.concat_map of_set sets)

(* {1 Means} *)

(* Boxes whose corners are multiples of 1/4. *)
let parts_in_a_unit = 4

let on_the_grid (p : Scc_regions.Chances.part) =
  let holds (c : Constraint.t) =
    match List.filter (fun a -> Z.sign a <> 0) (Array.to_list c.normal) with
    | [ a ] -> Z.divisible (Z.mul c.right (Z.of_int parts_in_a_unit)) a
    | _ -> false
  in
  List.for_all (fun piece -> List.for_all holds (Polyhedron.constraints piece)) (Union.pieces p.set)

let middles (r : Scc_calculus.Ranges.range) =
  let width = Rat.make Z.one (Z.of_int parts_in_a_unit) in
  let rec go x = if Rat.compare x r.high.value >= 0 then [] else x :: go (Rat.add x width) in
  go (Rat.add r.low.value (Rat.div width (Rat.of_int 2)))

let rec products = function
  | [] -> [ [] ]
  | first :: rest ->
    let tails = products rest in
    List.concat_map (fun x -> List.map (List.cons x) tails) first

(* The mean is that of the values of single starts, each in the middle of a cell. [None] if it does not apply. *)
let mean_of_grid text (l : Loaded.t) (side, (c : Scc_regions.Chances.t)) =
  let starts = products (List.map middles (Array.to_list l.model.ranges)) in
  if List.length starts > 36 || not (List.for_all on_the_grid c.parts) then None
  else
    let name i = l.model.ranges.(i).Scc_calculus.Ranges.name in
    let value start =
      match single text (List.mapi (fun i x -> (name i, x)) start) with
      | Values list -> (
          match List.assoc side list with Some a, Some b when Rat.equal a b -> Some a | _ -> None)
      | Truth _ | Nothing -> None
    in
    let add sum x = Option.bind sum (fun sum -> Option.map (Rat.add sum) (value x)) in
    Option.map
      (fun sum -> Rat.div sum (Rat.of_int (List.length starts)))
      (List.fold_left add (Some Rat.zero) starts)

type count = {
  mutable models : int;
  mutable starts : int;
  mutable exactly : int;
  mutable pieces : int;
  mutable means : int;
  mutable kinds : (string * int) list;
}

let count = { models = 0; starts = 0; exactly = 0; pieces = 0; means = 0; kinds = [] }

let bump kind =
  let n = Option.value (List.assoc_opt kind count.kinds) ~default:0 in
  count.kinds <- (kind, n + 1) :: List.remove_assoc kind count.kinds

let try_mean text number l starts =
  match (mean_of_grid text l starts, Scc_regions.Chances.mean (snd starts)) with
  | None, _ -> ()
  | Some expected, Between { low = Some low; high = Some high }
    when Rat.equal low expected && Rat.equal high expected ->
    count.means <- count.means + 1
  | Some expected, found ->
    let found =
      match found with
      | Between { low = Some low; _ } -> Rat.to_string low
      | Between { low = None; _ } | Not_known _ | Not_computed -> "none"
    in
    Alcotest.failf "model %d of seed %d: the mean of a grid is %s, over all %s\n%s" number seed
      (Rat.to_string expected) found text

let try_model number =
  let random = Random.State.make [| seed; number |] in
  let text = model random in
  match load text with
  | _ when Option.is_some fine && String.equal text (at_instants text) -> ()
  | Error faults ->
    if Sys.getenv_opt "SHOW" <> None then
      List.iter (fun (d : Scc_base.Diag.t) -> print_endline (d.message ^ "\n" ^ text)) faults;
    bump "refused"
  | Ok l -> (
      let { Loaded.semantics; declared; checks; _ } = l in
      let uncertain = Option.get l.uncertain in
      let options = over_zones l.model.ranges in
      let zones = 1 + Random.State.int random 100 in
      let options = if chance random 15 then given_up_after random zones options else options in
      match Zone_check.run options semantics uncertain ~declared ~exactly:true ~premises:[] checks with
      | Error _ -> bump "ill-formed"
      | Ok report ->
        count.models <- count.models + 1;
        bump (match (outcome report).verdict with
            | Measured { reasons = []; starts; _ } ->
              count.pieces <-
                count.pieces
                + List.fold_left (fun n (_, (c : Scc_regions.Chances.t)) -> n + List.length c.parts) 0 starts;
              "measured"
            | Measured _ -> "measured in part"
            | Holds _ | Violated _ | Depends _ -> "decided"
            | Undecided (r :: _) -> Verdict.reason_to_string r
            | Undecided [] -> "undecided");
        let any = not (String.equal text (at_instants text)) in
        let try_point point =
          let name i = l.model.ranges.(i).Scc_calculus.Ranges.name in
          let overrides = List.mapi (fun i x -> (name i, x)) (Array.to_list point) in
          let one = single (at_instants text) overrides and all = over_starts report point in
          count.starts <- count.starts + 1;
          if exact one && exact all then count.exactly <- count.exactly + 1;
          if not (agree ~any:(any && Option.is_none fine) one all) then
            Alcotest.failf "model %d of seed %d, %s: of one start %s, over all %s\n%s" number seed
              (Verdict.values_to_string overrides) (told one) (told all) text
        in
        List.iter try_point (points random l report);
        match (outcome report).verdict with
        | Measured { reasons = []; starts; _ } when not any -> List.iter (try_mean text number l) starts
        | _ -> ())

let all () =
  let models = argument 1 40 in
  for i = 1 to models do
    try_model i
  done;
  let { models; starts; exactly; pieces; means; _ } = count in
  Printf.printf "%d models at %d starts, at %d both exact; %d values; %d means\n" models starts exactly pieces
    means;
  List.iter (fun (kind, n) -> Printf.printf "  %4d %s\n" n kind) (List.sort compare count.kinds);
  let too_few = count.exactly * 2 < count.starts || count.means * 4 < models in
  if too_few && Option.is_none fine then Alcotest.fail "too little is known"

(* The arguments are a number of models and a seed. *)
let () =
  Alcotest.run ~argv:[| Sys.argv.(0) |] "chance over zones"
    [ ("random models", [ Alcotest.test_case "Starts: as from single starts" `Quick all ]) ]
