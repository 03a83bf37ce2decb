(* Probabilities over all starts are those of the ordinary exploration, at each start: random models with one or
   two walkers, up to three parameters that delays and predicates may mention, walls, receptors, bonds that break
   by chance or at any time, and free choices. Each is asked at random starts, on borders of pieces too. Their
   means are those of grids, where all pieces are boxes with corners on the grid.

   test_chance [MODELS [SEED]] *)

open Scc_exact
open Scc_polyhedra
open Scc_graph_search
open Scc_verify
open Scc_zones
module Loaded = Scc_loading.Loaded

let argument i default = if Array.length Sys.argv > i then int_of_string Sys.argv.(i) else default
let seed = argument 2 1
let pick random list = List.nth list (Random.State.int random (List.length list))
let chance random percent = Random.State.int random 100 < percent

(* {1 Random models} *)

let number random list = pick random list

let velocity random ~plane =
  let one () = number random [ "0"; "1"; "-1"; "1"; "-1"; "1/2"; "2" ] in
  Printf.sprintf "(%s, %s, 0)" (one ()) (if plane then one () else "0")

let condition random ~plane =
  let variable = if plane then pick random [ "x"; "y" ] else "x" in
  let relation = pick random [ "<"; "<="; ">"; ">=" ] in
  Printf.sprintf "%s %s %s" variable relation (number random [ "0"; "1/2"; "1"; "-1" ])

let law random ~plane =
  let kick () =
    let weight = string_of_int (1 + Random.State.int random 3) in
    let weight =
      if chance random 15 then Printf.sprintf "(if %s then %s else 1)" (condition random ~plane) weight else weight
    in
    let v = velocity random ~plane in
    let v =
      if chance random 15 then
        Printf.sprintf "(if %s then 1 else -1, 0, 0)" (condition random ~plane)
      else v
    in
    Printf.sprintf "%s weight %s" v weight
  in
  if chance random 15 then velocity random ~plane
  else
    let kicks = List.init (2 + Random.State.int random 2) (fun _ -> kick ()) in
    Printf.sprintf "choose { %s }" (String.concat ", " kicks)

let shape =
  {|shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
|}

let formula random ~two ~plane ~any =
  let state () =
    pick random
      ([ "x(w) >= 1"; "x(w) > 1/2"; "bound(w, s)"; "event bounce(w)"; "event bind"; "vx(w) > 0"; "not bound(w, s)";
         "x(w) <= 0"; "behaviour(s) = Site"; "energy > 1"; "event bounce(w, east)"; "x(w) > start";
         "x(w) = start"; "behaviour(w) = Ready" ]
       @ (if two then [ "x(v) > x(w)"; "event bounce(v, w)" ] else [])
       @ if plane then [ "y(w) > 1"; "y(w) <= x(w)" ] else [])
  in
  let bound () = number random [ "1"; "3/2"; "2"; "2"; "5/2"; "3" ] in
  (* A claim that may fail on the way to the goal, while nothing else happens. *)
  let on_the_way () =
    let place = number random [ "1/4"; "1/2"; "3/4"; "1"; "5/4" ] in
    Printf.sprintf "P = ? [ (not x(w) = %s) U[<= %s] x(w) > %s ]" place (bound ())
      (number random [ "0"; "1/2"; "1"; "3/2" ])
  in
  match Random.State.int random 8 with
  | _ when any && chance random 60 ->
    let released = pick random [ "eventually event weak"; "always not event weak"; "true U[1, 3] bound(w, s)" ] in
    if String.contains released 'U' then Printf.sprintf "P = ? [ %s ]" released
    else Printf.sprintf "P = ? [ %s within %s ]" released (number random [ "2"; "5/2"; "3" ])
  | 0 -> Printf.sprintf "P = ? [ always %s within %s ]" (state ()) (bound ())
  | 1 -> Printf.sprintf "P = ? [ (%s) U[<= %s] (%s) ]" (state ()) (bound ()) (state ())
  | 2 -> Printf.sprintf "P = ? [ true U[%s, %s] (%s) ]" (number random [ "1/2"; "1" ]) (bound ()) (state ())
  | 3 -> Printf.sprintf "Pmin = ? [ eventually %s within %s ]" (state ()) (bound ())
  | 4 ->
    let least = number random [ "1/2"; "1/3"; "1"; "2/9" ] in
    Printf.sprintf "P >= %s [ eventually %s within %s ]" least (state ()) (bound ())
  | 5 -> on_the_way ()
  | _ -> Printf.sprintf "P = ? [ eventually %s within %s ]" (state ()) (bound ())

let any_time = "split_step any\n"

let model random =
  let two = chance random 30 and plane = chance random 25 in
  let deep = plane && chance random 40 and apart = two && chance random 30 in
  let buffer = Buffer.create 1000 in
  let add format = Printf.bprintf buffer format in
  add "model m\ntimestep 1%s\n" (if chance random 30 then " steady" else "");
  let bonds = chance random 40 in
  (* With two walkers each more instant at which bonds may break is costly. *)
  let any = bonds && (not two) && chance random 60 in
  if bonds then add "%s" (if any then any_time else "split_step 1\n");
  add "param start in %s\n"
    (pick random (if any then [ "[1, 5/2]"; "(3/2, 3]" ] else [ "[0, 2]"; "(-1, 2]"; "[1/2, 5/2)"; "[-1, 1]" ]));
  if plane then add "param height in %s\n" (pick random [ "[0, 2]"; "[-1, 1/2)" ]);
  if deep then add "param depth in %s\n" (pick random [ "[1, 3]"; "(3/2, 5/2]" ]);
  if apart then add "param other in %s\n" (pick random [ "[-9/2, -4]"; "(-5, -4)" ]);
  add "%s" shape;
  let weak =
    if not bonds then ""
    else if any then "omega(b, {left}). "
    else "omega(b, {left}) " ^ pick random [ "chance 1/3"; "rate 1"; "" ] ^ ". "
  in
  add "behaviour Site on Cube = <b, {left}>. %snil\n" weak;
  add "behaviour Ligand on Cube = %sReady\n"
    (if chance random 25 then pick random [ "eps(3/4). "; "eps(1 + start / 2). " ] else "");
  add "behaviour Ready on Cube = <~b, {%s}>. %snil\n"
    (pick random [ "right"; "only right" ])
    (if bonds then "omega(b, {right}). " else "");
  let inert = if any then "Ligand" else pick random [ "nil"; "Ligand"; "Ligand" ] in
  add "process w = Cube mass 1 at translate (start, %s, %s) [%s]\n" (if plane then "height" else "0")
    (if deep then "depth" else "0") inert;
  if two then add "process v = Cube mass %s at translate (%s, 0, %s) velocity (%s, 0, 0) [nil]\n"
      (pick random [ "1"; "2" ])
      (if apart then "other" else pick random [ "-7/2"; "-4" ])
      (pick random [ "0"; "0"; "1" ])
      (pick random [ "1"; "0" ]);
  add "fixed s = Cube at translate (%s, %s, 0) [Site]\n" (pick random [ "5"; "11/2" ]) (pick random [ "0"; "1" ]);
  add "fixed east = Cube scaled (1, 9, 9)%s at translate (%s, 0, 0)\n"
    (if chance random 20 then " absorb" else "")
    (pick random [ "15/2"; "8" ]);
  add "fixed west = Cube scaled (1, 9, 9) at translate (%s, 0, 0)\n"
    (if two then "-7" else pick random [ "-3"; "-4"; "-7/2" ]);
  add "motion w = %s\n" (law random ~plane);
  if two && chance random 50 then add "motion v = %s\n" (law random ~plane:false);
  add "check c : %s\n" (formula random ~two ~plane ~any);
  Buffer.contents buffer

(* {1 Both ways} *)

(* Bonds that may break at any time may do so at these instants. *)
let at_instants = Str.global_replace (Str.regexp_string any_time) "split_step 1/2\n"

let load ?(overrides = []) text =
  let read_file _ = Error "no file" in
  Loaded.load ~read_file ~overrides (Scc_base.Source.make ~name:"m.sc" text)

let options_of states =
  { Setup.default with bounds = { Bounds.default with states = Given states; depth = Given 60 } }
let options = options_of 4_000

(* Of two walkers with starts of their own, values have pieces by the hundred. *)
let over_zones ranges =
  if Option.is_some (Scc_calculus.Ranges.find ranges "other") then options_of 150 else options

(* Work that is given up after so many zones. *)
let given_up_after zones (options : Setup.t) =
  let left = ref zones in
  let run (type a) (stage : Limits.stage) (f : unit -> a) : (a, Limits.stop) result =
    match stage with
    | Concluding | Reporting -> Ok (f ())
    | Exploring | Proving ->
      decr left;
      if !left < 0 then Error Seconds else Ok (f ())
  in
  let bounds = { options.bounds with seconds = Given 1. } in
  { options with bounds; surroundings = Limits.undivided ~attempt:{ run } () }

module Side = struct
  type t = Scc_property.Property.side = Least | Greatest
end

type answer = Values of (Side.t * (Rat.t * Rat.t)) list | Truth of bool option | Nothing

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
              let known = Option.get in
              (side, (known (Scc_chance.Answer.lower m.least), known (Scc_chance.Answer.upper m.most)))
            in
            Values (List.map ends values)
          | Holds _ | Depends _ | Undecided _ -> Nothing))

let at point (side, (c : Scc_regions.Chances.t)) =
  let part = List.find (fun (p : Scc_regions.Chances.part) -> Union.mem p.set point) c.parts in
  (side, (part.value.least, part.value.most))

let over_starts (report : Check.report) point =
  match (outcome report).verdict with
  | Measured { starts; _ } -> Values (List.map (at point) starts)
  | Holds _ | Violated _ | Depends _ | Undecided _ ->
    let w = List.hd report.where in
    if Union.mem w.holds point then Truth (Some true)
    else if Union.mem w.fails point then Truth (Some false)
    else Truth None

let told = function
  | Values list ->
    String.concat "; " (List.map (fun (_, (a, b)) -> Rat.to_string a ^ " .. " ^ Rat.to_string b) list)
  | Truth (Some b) -> string_of_bool b
  | Truth None -> "not known"
  | Nothing -> "nothing"

(* Each knows the value, or bounds of it: they must be of one value. Exact values of one start are those of all.
   If bonds break at any time there, and [one] has them break at some instants, the least value is at most that of
   [one], and the greatest at least. *)
let agree ~any one all =
  match (one, all) with
  | Values one, Values all ->
    let same ((side : Side.t), (a, b)) (_, (c, d)) =
      (Rat.compare a d <= 0 || (any && side = Least)) && (Rat.compare c b <= 0 || (any && side = Greatest))
    in
    List.for_all2 same one all
  | Truth (Some a), Truth (Some b) -> if any then a || not b else Bool.equal a b
  | Truth _, Truth None | Truth None, Truth _ | Nothing, _ -> true
  | _ -> false

let exact = function
  | Values list -> List.for_all (fun (_, (a, b)) -> Rat.equal a b) list
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
      List.concat_map (fun (_, (c : Scc_regions.Chances.t)) -> List.map set c.parts) starts
    | Holds _ | Violated _ | Depends _ | Undecided _ ->
      let w = List.hd report.where in
      [ w.holds; w.fails ]
  in
  List.filter in_range (List.init 12 (fun _ -> random_point ()) @ List.concat_map of_set sets)

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
          match List.assoc side list with a, b when Rat.equal a b -> Some a | _ -> None)
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
  | Some expected, Some { least; most } when Rat.equal least expected && Rat.equal most expected ->
    count.means <- count.means + 1
  | Some expected, found ->
    let found = Option.fold ~none:"none" ~some:(fun (v : Piecewise.value) -> Rat.to_string v.least) found in
    Alcotest.failf "model %d of seed %d: the mean of a grid is %s, over all %s\n%s" number seed
      (Rat.to_string expected) found text

let try_model number =
  let random = Random.State.make [| seed; number |] in
  let text = model random in
  match load text with
  | Error faults ->
    if Sys.getenv_opt "SHOW" <> None then
      List.iter (fun (d : Scc_base.Diag.t) -> print_endline (d.message ^ "\n" ^ text)) faults;
    bump "refused"
  | Ok l -> (
      let { Loaded.semantics; declared; checks; _ } = l in
      let uncertain = Option.get l.uncertain in
      let options = over_zones l.model.ranges in
      let zones = 1 + Random.State.int random 100 in
      let options = if chance random 15 then given_up_after zones options else options in
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
          if not (agree ~any one all) then
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
  if count.exactly * 2 < count.starts || count.means * 4 < models then Alcotest.fail "too little is known"

(* The arguments are a number of models and a seed. *)
let () =
  Alcotest.run ~argv:[| Sys.argv.(0) |] "chance over zones"
    [ ("random models", [ Alcotest.test_case "Starts: as from single starts" `Quick all ]) ]
