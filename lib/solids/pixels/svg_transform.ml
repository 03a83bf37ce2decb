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

let plain text =
  match with_unit text with
  | q, "" -> q
  | _, "%" -> unread "shares (%%) in transforms"
  | _ -> bad "the number %S in a transform" text

let angle text =
  let times n d q = Rat.mul q (Rat.make (Z.of_int n) (Z.of_int d)) in
  match with_unit text with
  | q, "deg" -> q
  | q, "grad" -> times 9 10 q
  | q, "turn" -> times 360 1 q
  | q, "rad" -> Rat.div (times 180 1 q) Angle.pi
  | q, "" when Rat.sign q = 0 -> zero
  | _ -> bad "the angle %S in a transform of a style, which has to be in deg, grad, rad or turn" text

let distance text =
  match with_unit text with
  | q, "" when Rat.sign q <> 0 ->
    bad "the length %S without a unit in a transform of a style, which browsers ignore" text
  | _, "%" -> unread "shares (%%) in transforms"
  | _ -> length text

let skewed_by_css axis a =
  match Plane_map.skewing axis a with Some m -> m | None -> unread "a skew by a right angle"

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
  | ("skew" | "skewx"), [ a ] -> skewed_by_css `X (angle a)
  | "skewy", [ a ] -> skewed_by_css `Y (angle a)
  | _ -> unread "the transform %S with %d values in a style" name (List.length values)

(* {1 Lists of them} *)

(* The arguments of a function of CSS. *)
let arguments text = List.map String.trim (String.split_on_char ',' text)

let functions text each =
  let c = cursor text in
  let rec go map =
    if ended c then map
    else
      match String.index_from_opt text c.at '(' with
      | None -> bad "the transform %S" text
      | Some i -> (
          match String.index_from_opt text i ')' with
          | None -> bad "the transform %S" text
          | Some j ->
            skip c;
            let name = String.trim (String.sub text c.at (i - c.at)) in
            c.at <- j + 1;
            go (Plane_map.compose map (each name (String.sub text (i + 1) (j - i - 1)))))
  in
  if String.equal (String.lowercase_ascii (String.trim text)) "none" then Plane_map.identity
  else go Plane_map.identity

let of_text text = functions text (fun name values -> of_attribute name (all values))

(* {1 The origin} *)

let share ~css whole text =
  match with_unit text with
  | q, "%" -> Rat.mul whole (Rat.div q (Rat.of_int 100))
  | q, "" when css && Rat.sign q <> 0 ->
    bad "the transform-origin %S without a unit in a style, which browsers ignore" text
  | _ -> length text

let origin ~css ~size:(w, h) text =
  let fault () = unread "the transform-origin %S" text in
  let along whole (first, last) = function
    | "center" -> Rat.mul Rat.half whole
    | word when word = first -> zero
    | word when word = last -> whole
    | "left" | "right" | "top" | "bottom" -> fault ()
    | text -> share ~css whole text
  in
  let across = along w ("left", "right") and down = along h ("top", "bottom") in
  let pair x y =
    (* Two words may come in either order. *)
    match (x, y) with
    | ("top" | "bottom"), ("left" | "right" | "center") | "center", ("left" | "right") -> (across y, down x)
    | _ -> (across x, down y)
  in
  let blank c = if is_blank c then ' ' else c in
  match List.filter (( <> ) "") (String.split_on_char ' ' (String.map blank text)) with
  | [ (("top" | "bottom") as y) ] -> pair "center" y
  | [ x ] -> pair x "center"
  | [ x; y ] -> pair x y
  | [ x; y; z ] when Rat.sign (length z) = 0 -> pair x y
  | _ -> fault ()

let of_style text = functions text (fun name values -> of_css name (arguments values))

let boxes =
  [
    "content-box"; "border-box"; "fill-box"; "stroke-box"; "view-box"; "inherit"; "initial"; "unset"; "revert";
    "revert-layer";
  ]

let is_valid name text =
  let text = String.lowercase_ascii text in
  let check () =
    match name with
    | _ when List.mem text [ "inherit"; "initial"; "unset"; "revert"; "revert-layer" ] -> ()
    | "transform" -> if String.trim text = "" then bad "no transform" else ignore (of_style text)
    | "transform-origin" -> ignore (origin ~css:true ~size:(Rat.one, Rat.one) text)
    | _ -> if not (List.mem text boxes || String.contains text '(') then bad "the transform-box %S" text
  in
  match check () with () | (exception Unread _) -> true | exception Bad _ -> false

let of_properties ~size properties =
  let last names = List.find_opt (fun (name, _) -> List.mem name names) (List.rev properties) in
  let map =
    match last [ "transform"; "css transform" ] with
    | None -> Plane_map.identity
    | Some ("transform", text) -> of_text text
    | Some (_, text) -> of_style text
  in
  (* Without a transform the origin and the box matter nothing; they are to have values all the same. *)
  let moves = not (Plane_map.is_identity map) in
  (match last [ "transform-box" ] with
   | None | Some (_, "view-box") -> ()
   | Some (_, other) when not (List.mem other boxes) -> bad "the transform-box %S" other
   | Some (_, other) -> if moves then unread "the transform-box %S" other);
  match last [ "transform-origin"; "css transform-origin" ] with
  | None -> map
  | Some (css, text) -> (
      match origin ~css:(css = "css transform-origin") ~size text with
      | x, y -> if moves then about x y map else map
      | exception Unread _ when not moves -> map)
