open Scc_exact
open Scc_picture
open Cmdliner

type t = { from : Vec.t option; up : Vec.t option; width : int option }

let looks t = Option.is_some t.from || Option.is_some t.up
let given t = looks t || Option.is_some t.width

let direction =
  let number text = Arg.conv_parser Options.rational (String.trim text) in
  let parse text =
    match String.split_on_char ',' text with
    | [ x; y; z ] ->
      let* x = number x in
      let* y = number y in
      let* z = number z in
      let v = Vec.make x y z in
      if Vec.is_zero v then Error (`Msg (Printf.sprintf "`%s' is no direction" text)) else Ok v
    | _ -> Error (`Msg (Printf.sprintf "`%s' is not of the form X,Y,Z" text))
  in
  let print ppf (v : Vec.t) =
    Format.pp_print_string ppf (String.concat "," (List.map Rat.to_string [ v.x; v.y; v.z ]))
  in
  Arg.conv ~docv:"X,Y,Z" (parse, print)

let from =
  Options.maybe direction [ "from" ] ~docv:"X,Y,Z"
    "With $(b,--svg): looks from the side to which the vector $(docv) points: $(b,0,1,0) is from above. Write \
     $(b,--from=-1,0,0) if it begins with a minus."

let up =
  Options.maybe direction [ "up" ] ~docv:"X,Y,Z"
    "With $(b,--svg): the direction that is upwards in the picture, by default the y axis, or another axis if \
     the view is along it."

let width =
  let doc = "With $(b,--svg): the width of the picture, in pixels." in
  let least, most = Sheet.width_limits in
  Arg.(value & opt (some (Options.integer ~least ~most "width")) None & info [ "width" ] ~docv:"PIXELS" ~doc)

let term = Term.(const (fun from up width -> { from; up; width }) $ from $ up $ width)
let or_default option default = Option.value ~default option

let of_state t camera ~names ~without =
  let d = Picture.default in
  let from = or_default t.from d.from and up = or_default t.up d.up in
  let of_link = Option.bind camera (fun (c : Camera_link.t) -> c.width) in
  let width = or_default t.width (or_default of_link d.width) in
  let page = Option.map (fun (c : Camera_link.t) -> c.page) camera in
  { d with names; without; from; up; width; page }

let of_solid t : Solid_picture.options =
  let d = Solid_picture.default in
  { from = or_default t.from d.from; up = or_default t.up d.up; width = or_default t.width d.width }
