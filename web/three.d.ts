/** three.js, revision 111: it comes with the page, and is not checked here. */
declare const THREE: any;
