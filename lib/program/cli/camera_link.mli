(** The camera in a link of the page of [scc view]. *)

(** A camera, and the width of its picture. *)
type t = {
  page : Scc_picture.Page_camera.t;
  width : int option;  (** in pixels, if the link has it and a drawing may be so wide *)
}

val read : string -> (t, string) result
(** [read link] is the camera of a link, or of what follows [#] in it: its part [camera], and its part [size], as
    [800x600], which is 800x600 if there is none. The error is a sentence without its end. *)
