open Scc_base
open Scc_exact
open Scc_json
open Scc_picture

type t = { page : Page_camera.t; width : int option }

let parts link =
  let fragment =
    match String.index_opt link '#' with
    | Some i -> String.sub link (i + 1) (String.length link - i - 1)
    | None -> link
  in
  let part text =
    Option.map
      (fun i -> (String.sub text 0 i, Percent.decoded (String.sub text (i + 1) (String.length text - i - 1))))
      (String.index_opt text '=')
  in
  List.filter_map part (String.split_on_char '&' fragment)

let number = function
  | `Int n -> Some (Rat.of_int n)
  | `Float x when Float.is_finite x -> Some (Q.of_float x)
  | _ -> None

let within low high x = if Rat.compare low x <= 0 && Rat.compare x high <= 0 then Some x else None
let power n = Rat.make (Z.pow (Z.of_int 10) n) Z.one

(* The page looks straight down at most nearly, and never from farther than this. *)
let steepest = Rat.make (Z.of_int 155) (Z.of_int 100)

let coordinate json =
  let* text = Option.to_result ~none:() (Json.string json) in
  let* x = Result.map_error ignore (Rat.of_literal text) in
  Ok x

let target json =
  match Option.map (List.map coordinate) (Option.bind (Json.member "at" json) Json.list) with
  | Some [ Ok x; Ok y; Ok z ] -> Some (Vec.make x y z)
  | _ -> None

let camera ~aspect json =
  let field name low high =
    Option.bind (Option.bind (Json.member name json) number) (within low high)
  in
  let*? at = target json in
  let*? distance = field "distance" (Rat.div Rat.one (power 7)) (power 13) in
  let*? turn = field "turn" (Rat.neg (power 9)) (power 9) in
  let*? height = field "height" (Rat.neg steepest) steepest in
  let*? up =
    match Option.map Json.string (Json.member "up" json) with
    | None | Some (Some "y") -> Some Vec.Y
    | Some (Some "x") -> Some Vec.X
    | Some (Some "z") -> Some Vec.Z
    | Some _ -> None
  in
  let parallel = match Json.member "parallel" json with Some (`Bool b) -> b | _ -> false in
  Some { Page_camera.at; distance; turn; height; parallel; up; aspect }

let most_pixels = 100_000

let size text =
  let side text =
    match int_of_string_opt text with Some n when n > 0 && n <= most_pixels -> Some n | Some _ | None -> None
  in
  match List.map side (String.split_on_char 'x' text) with
  | [ Some w; Some h ] -> Some (w, h)
  | _ -> None

(* The frame of a page that does not say how large it was. *)
let usual = (800, 600)

let read link =
  let parts = parts link in
  let said name = List.assoc_opt name parts in
  match (said "camera", Option.map size (said "size")) with
  | None, _ -> Error "it has no camera: copy the link of a page of scc view, or what follows # in it"
  | _, Some None -> Error "its size is not of the form 800x600"
  | Some text, (None | Some (Some _) as given) -> (
      let w, h = Option.value (Option.join given) ~default:usual in
      let aspect = Rat.make (Z.of_int w) (Z.of_int h) in
      let parsed = Json.parse (Source.make ~name:"camera" text) in
      match Option.bind (Result.to_option parsed) (camera ~aspect) with
      | None -> Error "its camera is not one of a page of scc view"
      | Some page ->
        let least, most = Sheet.width_limits in
        let fits = Option.is_some given && w >= least && w <= most in
        Ok { page; width = (if fits then Some w else None) })
