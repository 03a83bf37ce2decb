open Scc_exact
open Svg_number

let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format
let unread format = Printf.ksprintf (fun m -> raise (Unread m)) format
let zero = Rat.zero

(* {1 Functions} *)

let rotated a = Plane_map.rotation a

let about x y map = Plane_map.(compose (translation x y) (compose map (translation (Rat.neg x) (Rat.neg y))))

let skewed axis a =
  match Plane_map.skewing axis a with Some m -> m | None -> raise (Bad "a skew by a right angle")

let matrix a b c d e f = { Plane_map.a; b; c; d; e; f }

(* As an attribute: numbers without units. *)
let of_attribute name values =
  match (name, values) with
  | "matrix", [ a; b; c; d; e; f ] -> matrix a b c d e f
  | "translate", [ x; y ] -> Plane_map.translation x y
  | "translate", [ x ] -> Plane_map.translation x zero
  | "scale", [ x; y ] -> Plane_map.scaling x y
  | "scale", [ x ] -> Plane_map.scaling x x
  | "rotate", [ a ] -> rotated a
  | "rotate", [ a; x; y ] -> about x y (rotated a)
  | "skewX", [ a ] -> skewed `X a
  | "skewY", [ a ] -> skewed `Y a
  | _ -> bad "the transform %S with %d numbers" name (List.length values)

(* {1 Functions of CSS, whose lengths and angles have units} *)

(* A number and what follows it up to a comma or a blank. *)
let argument text =
  let c = { text; at = 0 } in
  let q = number c in
  (q, String.lowercase_ascii (String.trim (String.sub text c.at (String.length text - c.at))))

let plain text =
  match argument text with
  | q, "" -> q
  | _ -> bad "the number %S in a transform" text

let angle text =
  let times n d q = Rat.mul q (Rat.make (Z.of_int n) (Z.of_int d)) in
  match argument text with
  | q, "deg" -> q
  | q, "grad" -> times 9 10 q
  | q, "turn" -> times 360 1 q
  | q, "rad" -> Rat.div (times 180 1 q) Angle.pi
  | q, "" when Rat.sign q = 0 -> zero
  | _ -> bad "the angle %S in a transform of a style, which has to be in deg, grad, rad or turn" text

let distance text =
  match argument text with
  | q, "" when Rat.sign q <> 0 ->
    bad "the length %S without a unit in a transform of a style, which browsers ignore" text
  | _, "%" -> unread "shares (%%) in transforms"
  | _ -> length text

let of_css name values =
  match (String.lowercase_ascii name, values) with
  | "matrix", [ a; b; c; d; e; f ] -> matrix (plain a) (plain b) (plain c) (plain d) (plain e) (plain f)
  | "translate", [ x; y ] -> Plane_map.translation (distance x) (distance y)
  | ("translate" | "translatex"), [ x ] -> Plane_map.translation (distance x) zero
  | "translatey", [ y ] -> Plane_map.translation zero (distance y)
  | "scale", [ x; y ] -> Plane_map.scaling (plain x) (plain y)
  | "scale", [ x ] -> Plane_map.scaling (plain x) (plain x)
  | "scalex", [ x ] -> Plane_map.scaling (plain x) Rat.one
  | "scaley", [ y ] -> Plane_map.scaling Rat.one (plain y)
  | "rotate", [ a ] -> rotated (angle a)
  | ("skew" | "skewx"), [ a ] -> skewed `X (angle a)
  | "skewy", [ a ] -> skewed `Y (angle a)
  | _ -> unread "the transform %S with %d values in a style" name (List.length values)

(* {1 Lists of them} *)

let split text =
  let blank = function ',' | '\t' | '\n' | '\r' -> ' ' | c -> c in
  List.filter (fun w -> w <> "") (String.split_on_char ' ' (String.map blank text))

let functions text each =
  let c = { text; at = 0 } in
  let rec go map =
    if ended c then map
    else
      match String.index_from_opt text c.at '(' with
      | None -> bad "the transform %S" text
      | Some i -> (
          match String.index_from_opt text i ')' with
          | None -> bad "the transform %S" text
          | Some j ->
            let name = String.trim (String.sub text c.at (i - c.at)) in
            c.at <- j + 1;
            go (Plane_map.compose map (each name (String.sub text (i + 1) (j - i - 1)))))
  in
  if String.equal (String.lowercase_ascii (String.trim text)) "none" then Plane_map.identity
  else go Plane_map.identity

(* {1 The origin} *)

let share whole text =
  match argument text with
  | q, "%" -> Rat.mul whole (Rat.div q (Rat.of_int 100))
  | _ -> length text

let origin ~size:(w, h) text =
  let half = Rat.mul Rat.half in
  let along whole = function
    | "center" -> half whole
    | "left" | "top" -> zero
    | "right" | "bottom" -> whole
    | text -> share whole text
  in
  let pair x y =
    (* Words may come in either order. *)
    match (x, y) with
    | ("top" | "bottom"), _ | _, ("left" | "right") -> (along w y, along h x)
    | _ -> (along w x, along h y)
  in
  match split text with
  | [ x ] -> pair x "center"
  | [ x; y ] -> pair x y
  | [ x; y; z ] when Rat.sign (length z) = 0 -> pair x y
  | _ -> unread "the transform-origin %S" text

let of_properties ~size properties =
  let last names = List.find_opt (fun (name, _) -> List.mem name names) (List.rev properties) in
  let map =
    match last [ "transform"; "css transform" ] with
    | None -> Plane_map.identity
    | Some ("transform", text) -> functions text (fun name values -> of_attribute name (all values))
    | Some (_, text) -> functions text (fun name values -> of_css name (split values))
  in
  if Plane_map.is_identity map then map
  else begin
    (match last [ "transform-box" ] with
     | None | Some (_, "view-box") -> ()
     | Some (_, other) -> unread "the transform-box %S" other);
    match last [ "transform-origin"; "css transform-origin" ] with
    | None -> map
    | Some (_, text) ->
      let x, y = origin ~size text in
      about x y map
  end
