# cmake -DHTML=FOLDER -P finish.cmake: gives the frame that shows what a search finds the site's colours. Doxygen gives
# its extra stylesheet to pages, but not to that frame.
file(READ ${HTML}/site.css style)
file(APPEND ${HTML}/search/search.css "${style}")
