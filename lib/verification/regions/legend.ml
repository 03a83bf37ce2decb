open Scc_exact
open Scc_polyhedra
open Scc_svg
open Scc_calculus

type t = { letter : string; colour : string; hatched : bool; name : string; share : string; told : string }

let shown (ranges : Ranges.t) (view : Plane.view) : Ranges.t =
  let end_ value : Ranges.bound = { value; included = true } in
  let height : Ranges.range = { name = ""; low = end_ Rat.zero; high = end_ Rat.one } in
  [| ranges.(view.across); (match view.up with Some up -> ranges.(up) | None -> height) |]

let projected (ranges : Ranges.t) view = List.map (Array.get ranges) (Plane.hidden ranges view)

let caption (ranges : Ranges.t) (view : Plane.view) =
  let fixed (i, x) = ranges.(i).name ^ " = " ^ Rat.to_string x in
  let any r = "any " ^ Ranges.range_to_string r in
  String.concat ", " (List.map fixed view.fixed @ List.map any (projected ranges view))

(* {1 Colours} *)

let nothing = "#888888"

let colour = Palette.colour

let letter i =
  let letter = String.make 1 (Char.chr (Char.code 'A' + (i mod 26))) in
  if i < 26 then letter else letter ^ string_of_int (i / 26)

(* {1 Words} *)

(* A claim, or a number as a function. *)
type subject = Claim | Number of Chances.t

let of_one ~on subject (outcome : Plane.outcome) =
  match (outcome, subject) with
  | Value i, Number c -> Words.value c.ranges (List.nth c.parts i).value
  | Value _, Claim -> Scc_base.Bug.fail __POS__ "a claim with a number"
  | Holds, _ -> "holds"
  | Fails, _ -> "fails"
  | Unknown, _ -> "not known"
  | Varies, _ -> "depends on " ^ on

let of_several ~on names subjects outcomes =
  let number name (subject, (outcome : Plane.outcome)) =
    match outcome with
    | Value _ -> [ name ^ " = " ^ of_one ~on subject outcome ]
    | Holds | Fails | Unknown | Varies -> []
  in
  let numbers = List.concat (List.map2 number names (List.combine subjects outcomes)) in
  let those wanted = List.concat (List.map2 (fun n o -> if o = wanted then [ n ] else []) names outcomes) in
  let with_ suffix = List.map (fun name -> name ^ suffix) in
  match
    those Plane.Holds @ with_ (" (depends on " ^ on ^ ")") (those Varies) @ with_ " (not known)" (those Unknown)
    @ numbers
  with
  | [] -> "none"
  | some -> String.concat ", " some

let most_pieces = 12

let where shown set =
  let pieces = Union.pieces set in
  let told = List.map (Words.piece shown) (List.filteri (fun i _ -> i < most_pieces) pieces) in
  let more = if List.compare_length_with pieces most_pieces > 0 then [ "..." ] else [] in
  String.concat "\nor " (told @ more)

let extent (view : Plane.view) = if view.up = None then 1 else 2

(* Among probabilities, the share of a region is not named one. *)
let share ~plain ranges (view : Plane.view) (r : Plane.region) =
  if Rat.sign r.share = 0 then Words.without_extent (extent view)
  else if plain && view.fixed = [] && projected ranges view = [] then "probability " ^ Words.number r.share
  else Words.number r.share ^ if view.up = None then " of the length" else " of the area"

let make ?(values = []) ranges view names regions =
  let subjects = List.map (fun _ -> Claim) names @ List.map (fun (_, c) -> Number c) values in
  let names = names @ List.map fst values in
  let on = String.concat ", " (List.map (fun (r : Ranges.range) -> r.name) (projected ranges view)) in
  let shown = shown ranges view in
  let fails (r : Plane.region) = List.for_all (fun o -> o = Plane.Fails) r.outcomes in
  let entry i (r : Plane.region) =
    let each =
      List.map2 (fun name told -> name ^ ": " ^ told) names (List.map2 (of_one ~on) subjects r.outcomes)
    in
    let name =
      match (subjects, r.outcomes) with
      | [ subject ], [ only ] -> of_one ~on subject only
      | _, several -> of_several ~on names subjects several
    in
    let share = share ~plain:(values = []) ranges view r in
    {
      letter = letter i;
      colour = (if fails r then nothing else colour i);
      hatched = List.mem Plane.Unknown r.outcomes;
      name;
      share;
      told = String.concat "\n" (each @ [ "where " ^ where shown r.set; share ]);
    }
  in
  List.mapi entry regions
