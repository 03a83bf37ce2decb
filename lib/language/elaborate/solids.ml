open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

(* {1 Hulls} *)

let max_points = 100

let hull report at list =
  if List.length list > max_points then begin
    Report.error report Code.too_deep at "this hull has more than %d points" max_points;
    None
  end
  else
    match Scc_mesh.Hull_of.named list with
    | None ->
      Report.error report Code.no_solid at "these points span no solid: all of them are in one plane";
      None
    | Some hull -> Some hull

(* {1 Solids that need no import} *)

let on_circle = Named_solids.on_circle
let names = [ "antiprism(_,_,_)"; "box(_,_,_)"; "prism(_,_,_)"; "pyramid(_,_,_)" ]
let is_predefined name = List.mem name [ "antiprism"; "box"; "prism"; "pyramid" ]
let max_corners = 256

(* A name that stands for nothing is a word. *)
let wrong report (r : Ast.reference) (arguments : Env.value list) takes =
  let word : Env.value -> string option = function Word (w, _) -> Some w | _ -> None in
  (match List.find_map word arguments with
   | Some name ->
     Report.error report Code.unknown_name r.target.at "unknown name `%s`; `%s` takes %s" name r.target.it takes
   | None -> Report.error report Code.bad_arity r.target.at "`%s` takes %s" r.target.it takes);
  None

let lengths = "three lengths, as in `box(2, 1, 1)`, or a vector of them"

let corners (r : Ast.reference) =
  Printf.sprintf "the number of corners, the radius and the height, as in `%s(6, 1, 2)`" r.target.it

let positive report (r : Ast.reference) numbers =
  if List.for_all (fun q -> Rat.sign q > 0) numbers then Some ()
  else begin
    Report.error report Code.bad_value r.target.at "the lengths of `%s` must be positive" r.target.it;
    None
  end

let made_box report r (arguments : Env.value list) =
  match arguments with
  | [ Number a; Number b; Number c ] | [ Vector { x = a; y = b; z = c } ] ->
    let*? () = positive report r [ a; b; c ] in
    Some (Named_solids.box a b c)
  | _ -> wrong report r arguments lengths

let round report (r : Ast.reference) make (arguments : Env.value list) =
  match arguments with
  | [ Number n; Number radius; Number height ] ->
    let corners = if Rat.is_integer n && Rat.bits n < 40 then Z.to_int (Rat.floor n) else 0 in
    if corners < 3 || corners > max_corners then begin
      Report.error report Code.bad_value r.target.at "`%s` has from 3 to %d corners, and not %s" r.target.it
        max_corners (Rat.to_string n);
      None
    end
    else
      let*? () = positive report r [ radius; height ] in
      Some (make corners radius height)
  | _ -> wrong report r arguments (corners r)

(* One argument that is not known may be a vector. *)
let check_open report (r : Ast.reference) (reference : Family.reference) =
  let is_number : Env.value -> bool = function Number _ | Unknown -> true | _ -> false in
  match (r.target.it, reference.arguments) with
  | "box", [ Unknown ] -> None
  | _, ([ _; _; _ ] as arguments) when List.for_all is_number arguments -> None
  | "box", arguments -> wrong report r arguments lengths
  | _, arguments -> wrong report r arguments (corners r)

let affine (reference : Family.reference) =
  List.find_map (function Env.Affine form -> Some form | _ -> None) reference.arguments

let label (r : Ast.reference) (reference : Family.reference) =
  match (r.qualifier, r.indices, r.arguments) with
  | None, [], _ :: _ when is_predefined r.target.it ->
    let n = String.length (Family.bare reference.label) in
    Some (r.target.it ^ String.sub reference.label n (String.length reference.label - n))
  | _ -> None

let find report (r : Ast.reference) (reference : Family.reference) =
  match (r.qualifier, r.indices, r.arguments, r.target.it) with
  | Some _, _, _, _ | _, _ :: _, _, _ | _, _, [], _ -> None
  | None, [], _ :: _, ("box" | "prism" | "antiprism" | "pyramid") when Option.is_some (affine reference) ->
    Option.iter (Not_linear.report report r.target.at ~why:Constant.of_shapes) (affine reference);
    Some None
  | None, [], _ :: _, ("box" | "prism" | "antiprism" | "pyramid") when Family.is_open reference ->
    Some (check_open report r reference)
  | None, [], _ :: _, "box" -> Some (made_box report r reference.arguments)
  | None, [], _ :: _, "prism" -> Some (round report r Named_solids.prism reference.arguments)
  | None, [], _ :: _, "antiprism" -> Some (round report r Named_solids.antiprism reference.arguments)
  | None, [], _ :: _, "pyramid" -> Some (round report r Named_solids.pyramid reference.arguments)
  | None, [], _ :: _, _ -> None
