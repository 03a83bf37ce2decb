open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax
open Scc_calculus

(* What was given, and whether it could be read. *)
type 'a given = { value : 'a option; at : Span.t }

type t = {
  mutable dynamics : Model.dynamics given option;
  mutable resolution : Rat.t given option;
  mutable orientation : int given option;
  mutable velocity : int given option;
  mutable collisions : Model.collisions given option;
  mutable binding : Model.binding given option;
  mutable bonds : Model.bonds given option;
  mutable blocked : Model.blocked given option;
}

let create () =
  {
    dynamics = None; resolution = None; orientation = None; velocity = None; collisions = None; binding = None;
    bonds = None; blocked = None;
  }

let once report earlier what (at : Span.t) value =
  match earlier with
  | Some first ->
    Report.error report Code.repeated_attribute at "`%s` is given twice" what
      ~notes:[ (first.at, "the first is here") ];
    earlier
  | None -> Some { value = value (); at }

(* One of some names, each with what it stands for. *)
let choice report what kinds (name : Ast.name) () =
  let found = List.assoc_opt name.it kinds in
  if Option.is_none found then
    Report.error report Code.unknown_name name.at "unknown %s `%s`; it is %s" what name.it
      (String.concat " or " (List.map fst kinds))
      ~near:(name.it, fun () -> List.map fst kinds);
  found

let dynamics t report (name : Ast.name) =
  let kinds : (string * Model.dynamics) list = [ ("constant_spin", Constant_spin); ("free_body", Free_body) ] in
  t.dynamics <- once report t.dynamics "dynamics" name.at (choice report "dynamics" kinds name)

let read_collisions t report (name : Ast.name) =
  let kinds : (string * Model.collisions) list =
    [ ("in_turn", In_turn); ("together", Together); ("drawn", Drawn) ]
  in
  t.collisions <- once report t.collisions "collisions" name.at (choice report "collisions" kinds name)

let read_binding t report (name : Ast.name) =
  let kinds : (string * Model.binding) list = [ ("collision", On_collision); ("contact", On_contact) ] in
  t.binding <- once report t.binding "binding" name.at (choice report "binding" kinds name)

let read_bonds t report (name : Ast.name) =
  let kinds : (string * Model.bonds) list = [ ("acyclic", Acyclic); ("cyclic", Cyclic) ] in
  t.bonds <- once report t.bonds "bonds" name.at (choice report "bonds" kinds name)

let read_blocked t report (name : Ast.name) =
  let kinds : (string * Model.blocked) list = [ ("bounce", Bounce); ("stop", Stop); ("wait", Wait) ] in
  t.blocked <- once report t.blocked "blocked" name.at (choice report "blocked" kinds name)

let resolution t report env (e : Ast.expr) =
  let value () = Constant.positive report env "resolution" e in
  t.resolution <- once report t.resolution "resolution" e.at value

(* k, of 2^-k; nothing coarser than halves. *)
let halvings q =
  let k = Z.numbits (Q.den q) - 1 in
  if Z.equal (Q.num q) Z.one && Z.equal (Q.den q) (Z.shift_left Z.one k) && k > 0 then Some k else None

let quantum report env what (e : Ast.expr) () =
  match Constant.number report env e with
  | None -> None
  | Some q ->
    let k = halvings q in
    if Option.is_none k then
      Report.error report Code.bad_value e.at
        "`round %s` takes a power of two that is at most 1/2, and this is %s" what (Rat.to_string q)
        ~hint:"write it as in `2^-20`";
    k

let round t report env (what : Ast.name) (e : Ast.expr) =
  let read earlier = once report earlier ("round " ^ what.it) what.at (quantum report env what.it e) in
  match what.it with
  | "orientation" -> t.orientation <- read t.orientation
  | "velocity" -> t.velocity <- read t.velocity
  | name ->
    Report.error report Code.unknown_name what.at "`round` is for `orientation` and `velocity`, not for `%s`" name
      ~near:(name, fun () -> [ "orientation"; "velocity" ])

(* {1 The default resolution} *)

let least_edge2 leaves =
  let of_edge (solid : Solid.t) (i, j) = Vec.norm2 (Vec.sub (Solid.vertex solid i) (Solid.vertex solid j)) in
  let of_part found (p : Model.part) =
    Array.fold_left
      (fun found edge -> Option.merge Rat.min found (Some (of_edge p.solid edge)))
      found p.solid.polyhedron.edges
  in
  Array.fold_left (fun found (l : Model.leaf) -> Array.fold_left of_part found l.parts) None leaves

(* The greatest power of two whose square is at most q, for q > 0: the lengths of q tell its exponent within
   two. *)
let power_below_root q =
  let rec down e = if Rat.compare (Rat.power_of_two (2 * e)) q <= 0 then Rat.power_of_two e else down (e - 1) in
  down (((Z.numbits (Q.num q) - Z.numbits (Q.den q)) / 2) + 2)

let default_resolution leaves =
  match least_edge2 leaves with
  | None -> Rat.one
  | Some edge2 -> power_below_root (Rat.mul edge2 (Rat.power_of_two (-40)))

let warn_without_effect t report =
  let warn what = function
    | None -> ()
    | Some at ->
      Report.warning report Code.no_effect at
        "`%s` has no effect: nothing spins, and the model has no `dynamics`" what
  in
  warn "resolution" (Option.map (fun g -> g.at) t.resolution);
  warn "round orientation" (Option.map (fun g -> g.at) t.orientation)

(* Within so much of a plane there may be all of a body, or features far from where it touches. *)
let warn_coarse report leaves (given : Rat.t given) =
  match (given.value, least_edge2 leaves) with
  | Some q, Some edge2 when Rat.compare (Rat.mul (Rat.of_int 64) (Rat.mul q q)) edge2 > 0 ->
    Report.warning report Code.coarse_resolution given.at
      "the resolution %s is coarse: it is more than an eighth of the shortest edge of the bodies" (Rat.to_string q)
      ~hint:"contacts are known within it: what is not near may count as touching"
  | _ -> ()

(* Whatever is near or far turns when it is hit, because of this one. *)
let warn_unstated t report (why, at) =
  if Option.is_none t.dynamics then
    Report.warning report Code.unstated_dynamics at
      "%s, so that all bodies of the model turn, and the model does not say by which `dynamics`" why
      ~hint:"write `dynamics constant_spin`, which is taken now, or `dynamics free_body`"

let value given = Option.bind given (fun g -> g.value)

let is_rigid t ~spins = spins || Option.is_some t.dynamics

let rigid t report ~spinning leaves =
  if not (is_rigid t ~spins:(Option.is_some spinning)) then begin
    warn_without_effect t report;
    None
  end
  else begin
    Option.iter (warn_unstated t report) spinning;
    Option.iter (warn_coarse report leaves) t.resolution;
    Some
      {
        Model.dynamics = Option.value ~default:Model.Constant_spin (value t.dynamics);
        resolution =
          (match value t.resolution with
           | Some q -> q
           | None -> default_resolution leaves);
        round_orientation = value t.orientation;
      }
  end

(* {1 Choices} *)

let collisions t = Option.value ~default:Model.In_turn (value t.collisions)

let round_velocity t = value t.velocity

let binding t = Option.value ~default:Model.On_collision (value t.binding)

let bonds t = Option.value ~default:Model.Acyclic (value t.bonds)

let blocked t = Option.value ~default:Model.Bounce (value t.blocked)

let check_blocked t report ~spins =
  match t.blocked with
  | Some { value = Some (Model.Stop | Wait); at } when is_rigid t ~spins || Option.is_some t.velocity ->
    Report.error report Code.not_yet at
      "walkers bounce where bodies turn or velocities are rounded: neither `blocked stop` nor `blocked wait` can \
       be had"
  | Some _ | None -> ()

let check t report ~spins =
  check_blocked t report ~spins;
  match t.binding with
  | Some { value = Some Model.On_contact; at } when is_rigid t ~spins ->
    Report.error report Code.not_yet at
      "bodies that turn bind when they collide, and not by contact: their contact is known within a resolution, \
       and the first instant of it is no rational number"
  | Some _ | None -> ()
